// Building and running the chapters of checkouts.
#include "builder.hpp"

#include <chrono>
#include <fstream>
#include <map>
#include <memory>
#include <thread>

#include "engine/system/file_error.hpp"
#include "engine/system/system.hpp"

#include "folder_lock.hpp"
#include "process.hpp"

namespace texmap::grade {
namespace {

/// Takes the lines that were added to the file since the last time.
void take_lines(std::ifstream& file, std::string& begun,
                const std::function<void(const TaskResult&)>& take) {
  file.clear();
  for (std::string line; std::getline(file, line);) {
    begun += line;
    if (file.eof()) return;  // the line is still being written
    take(task_result(begun));
    begun.clear();
  }
}

}  // namespace

void Builder::run(const std::vector<Task>& tasks,
                  const std::function<void(const TaskResult&)>& take,
                  const std::function<bool()>& stopped) const {
  const FolderLock lock(work, "--work");
  const std::filesystem::path plan = work / "plan.tsv";
  const std::filesystem::path results = work / "results.tsv";
  std::string lines;
  std::map<std::string, std::string> expected;  // the items of the tasks without a result
  for (const Task& task : tasks) {
    expected[task.id] = task.item;
    lines.append(task.id).append("\t").append(name_of(task.checkout));
    lines.append("\t").append(task.item).append("\n");
  }
  write_text_atomically(plan, lines);
  std::ofstream(results).close();  // empty, to be read while it grows

  std::vector<std::string> words;
  if (program.extension() == ".py") words.emplace_back("python3");
  words.insert(words.end(), {name_of(program), "--tree", name_of(tree), "--work", name_of(work),
                             "--plan", name_of(plan), "--results", name_of(results)});
  words.insert(words.end(), options.begin(), options.end());
  std::unique_ptr<Process> process;
  try {
    process = std::make_unique<Process>(words);
  } catch (const FileError& error) {
    throw FileError(std::string("checkouts need Linux with Python 3: ") + error.what() +
                    ". Folders of the pictures that students' programs drew are graded everywhere");
  }
  const auto take_expected = [&](const TaskResult& result) {
    const auto found = expected.find(result.id);
    if (found == expected.end() || found->second != result.item) {
      throw FileError("a line of results.tsv is of no task that is open: " + result.id + " " +
                      result.item);
    }
    expected.erase(found);
    take(result);
  };
  std::ifstream file(results);
  std::string begun;
  for (bool runs = true; runs && !stopped();) {
    runs = process->runs();
    take_lines(file, begun, take_expected);
    if (runs) std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  const int status = process->end();
  take_lines(file, begun, take_expected);
  if (stopped() || (status == 0 && expected.empty())) return;
  if (status == 0) {
    throw FileError(std::to_string(expected.size()) + " of " + std::to_string(tasks.size()) +
                    " tasks have no result, the first is " + expected.begin()->second +
                    "; grade once more");
  }
  if (status == 2) throw AlreadySaid("the checkouts were not graded");
  throw FileError("the program that builds and runs checkouts, " + name_of(program) +
                  ", did not run to its end; its message is above");
}

std::string unescaped_field(std::string_view field) {
  std::string text;
  for (std::size_t i = 0; i < field.size(); ++i) {
    if (field[i] != '\\' || i + 1 == field.size()) {
      text += field[i];
      continue;
    }
    ++i;
    text += field[i] == 't' ? '\t' : field[i] == 'n' ? '\n' : field[i];
  }
  return text;
}

TaskResult task_result(std::string_view line) {
  std::vector<std::string> fields;
  for (bool more = true; more;) {
    const std::size_t end = line.find('\t');
    more = end != std::string_view::npos;
    fields.push_back(unescaped_field(line.substr(0, end)));
    if (more) line.remove_prefix(end + 1);
  }
  if (fields.size() != 15) {
    throw FileError("a line of results.tsv has " + std::to_string(fields.size()) +
                    " fields and should have 15");
  }
  return {fields[0],          fields[1],           fields[2],           fields[3],
          fields[4],          fields[5],           fields[6],           path_of(fields[7]),
          path_of(fields[8]), path_of(fields[9]),  path_of(fields[10]), fields[11],
          fields[12],         fields[13] == "yes", fields[14]};
}

}  // namespace texmap::grade
