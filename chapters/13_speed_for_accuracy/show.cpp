// Runs the lesson: says how far it is, prints the tables, and writes plots, figures and the sheet.
#include "engine/app/budget_options.hpp"
#include "engine/system/system.hpp"
#include "lesson.hpp"
#include "progress.hpp"
#include "report.hpp"
#include "sheet.hpp"

namespace texmap::chapter_13 {

void Lesson::show(Session& session) {
  const Settings& settings = session.settings;
  std::vector<Budget> budgets = {read_budget("exact"), read_budget("texels=0.01"),
                                 read_budget("levels=1")};
  if (!budget.empty()) budgets.push_back(read_budget(budget));
  check_report(path_of(settings.out));
  const Globe globe(texture.load());
  const SheetLayout layout(settings.width, settings.height);
  const View<> view = globe.view(layout.panel_width, layout.panel_height);

  Measurements all;
  Ticks ticks(phases_of(rounds, widest));
  session.remark = [&ticks] { return ticks.remark(); };
  (void)session.timed(0, [&](const RenderSettings& render) {
    all = measure(globe, view, render.threads, [&] { ticks(render); });
    return Image();
  });
  const Image sheet = session.timed(rays_of(all), [&](const RenderSettings& render) {
    return draw_sheet(globe, settings.width, settings.height, render.threads,
                      [&] { ticks(render); });
  });

  write_report(path_of(settings.out), all);
  if (!settings.quiet) {
    std::string lines;
    const auto report = names_of_report(path_of(settings.out));
    if (!report.empty()) {
      lines =
          "Look first at the trade, time across and error up: " + texmap::name_of(report.front()) +
          "\n\n";
    }
    lines += table_of(all) + "\n";
    for (const Budget& each : budgets) lines += recommendation(all, each, globe.nearest.image);
    print(lines);
  }
  session.save(sheet);
}

}  // namespace texmap::chapter_13
