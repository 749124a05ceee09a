// The system's answers on Windows.
#define WIN32_LEAN_AND_MEAN
#define NOMINMAX
#include <windows.h>
// After windows.h, which they need.
#include <fcntl.h>
#include <io.h>
#include <shellapi.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <random>
#include <string>
#include <system_error>

#include "engine/files/shared.hpp"
#include "engine/files/system.hpp"

namespace texmap {
namespace {

constexpr DWORD quota_exceeded = 1295;  // ERROR_DISK_QUOTA_EXCEEDED, which mingw-w64 10 lacks

// The reason of the system's last failure, with the same words as elsewhere where they fit.
std::error_code last_error() {
  const DWORD error = GetLastError();
  switch (error) {
    case ERROR_FILE_NOT_FOUND:
    case ERROR_PATH_NOT_FOUND:
    case ERROR_INVALID_NAME:
    case ERROR_BAD_NETPATH:
      return std::make_error_code(std::errc::no_such_file_or_directory);
    case ERROR_ACCESS_DENIED:
    case ERROR_SHARING_VIOLATION:
    case ERROR_LOCK_VIOLATION:
      return std::make_error_code(std::errc::permission_denied);
    case ERROR_DISK_FULL:
    case ERROR_HANDLE_DISK_FULL:
    case quota_exceeded:
      return std::make_error_code(std::errc::no_space_on_device);
    case ERROR_FILENAME_EXCED_RANGE:
      return std::make_error_code(std::errc::filename_too_long);
    case ERROR_WRITE_PROTECT:
      return std::make_error_code(std::errc::read_only_file_system);
    default:
      return {static_cast<int>(error), std::system_category()};
  }
}

void require_success(bool succeeded) {
  if (!succeeded) throw FileError(words_of(last_error()));
}

// Owns a handle of the system.
struct Close {
  using pointer = HANDLE;
  void operator()(HANDLE handle) const { CloseHandle(handle); }
};
using Handle = std::unique_ptr<void, Close>;

Handle open_file(const std::filesystem::path& path, DWORD access, DWORD how) {
  // Others may read or replace the file meanwhile.
  const DWORD shared = FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE;
  const HANDLE opened =
      CreateFileW(path.c_str(), access, shared, nullptr, how, FILE_ATTRIBUTE_NORMAL, nullptr);
  return Handle(opened == INVALID_HANDLE_VALUE ? nullptr : opened);
}

// NUL and /dev/null discard what is written to them.
bool is_null_device(const std::filesystem::path& path) {
  std::string name = name_of(path.filename());
  std::transform(name.begin(), name.end(), name.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return name == "nul" || path == "/dev/null";
}

// The file to replace: where a symbolic link leads, if `path` is one.
std::filesystem::path end_of_links(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_symlink(path, error)) return path;
  std::filesystem::path end = std::filesystem::weakly_canonical(path, error);
  return error ? path : end;
}

void check_target(const std::filesystem::path& path) {
  check_name(path);
  if (is_null_device(path)) return;
  if (!path.has_filename() || path.filename() == "." || path.filename() == "..")
    throw FileError("the name is that of a folder");
  const std::filesystem::path target = end_of_links(path);
  if (target.filename().native().size() > 255)
    throw FileError(words_of(std::make_error_code(std::errc::filename_too_long)));
  check_folder(folder_of(target));
  const DWORD attributes = GetFileAttributesW(target.c_str());
  if (attributes == INVALID_FILE_ATTRIBUTES) {
    const std::error_code error = last_error();
    if (GetLastError() == ERROR_INVALID_NAME)
      throw FileError("the name has a character that names cannot have, such as ? or *");
    if (error != std::errc::no_such_file_or_directory) throw FileError(words_of(error));
    return;
  }
  if ((attributes & FILE_ATTRIBUTE_DIRECTORY) != 0) throw FileError("it is a folder");
  if ((attributes & FILE_ATTRIBUTE_READONLY) != 0)
    throw FileError("it cannot be written to: no permission");
}

void write_new_file(const std::filesystem::path& path, std::span<const std::uint8_t> bytes) {
  const Handle file = open_file(path, GENERIC_WRITE, CREATE_NEW);
  require_success(file != nullptr);
  while (!bytes.empty()) {
    DWORD written = 0;
    const auto part = static_cast<DWORD>(std::min<std::size_t>(bytes.size(), 1U << 30));
    require_success(WriteFile(file.get(), bytes.data(), part, &written, nullptr) != 0);
    bytes = bytes.subspan(written);
  }
}

// Windows refuses while another program reads the old file, so try again for a second.
void rename_over(const std::filesystem::path& draft, const std::filesystem::path& target) {
  constexpr int most_attempts = 200;
  for (int attempt = 1;; ++attempt) {
    if (MoveFileExW(draft.c_str(), target.c_str(),
                    MOVEFILE_REPLACE_EXISTING | MOVEFILE_WRITE_THROUGH) != 0)
      return;
    require_success(last_error() == std::errc::permission_denied && attempt < most_attempts);
    Sleep(5);
  }
}

}  // namespace

std::vector<std::uint8_t> read_file(const std::filesystem::path& path, std::uint64_t most_bytes) {
  check_name(path);
  if (is_null_device(path)) throw FileError("it is a device, not a file");
  std::error_code unknown;  // open_file says why
  if (std::filesystem::is_directory(path, unknown)) throw FileError("it is a folder, not a file");
  const Handle file = open_file(path, GENERIC_READ, OPEN_EXISTING);
  if (!file) {
    const std::error_code error = last_error();
    throw FileError(error == std::errc::permission_denied ? "no permission to read it"
                                                          : words_of(error));
  }
  if (GetFileType(file.get()) != FILE_TYPE_DISK) throw FileError("it is a device, not a file");
  LARGE_INTEGER size{};
  require_success(GetFileSizeEx(file.get(), &size) != 0);
  return read_whole(
      static_cast<std::uint64_t>(size.QuadPart), most_bytes,
      [&file](std::uint8_t* to, std::size_t bytes) {
        DWORD got = 0;
        require_success(ReadFile(file.get(), to, static_cast<DWORD>(bytes), &got, nullptr) != 0);
        return std::size_t{got};
      });
}

bool is_stream(const std::filesystem::path& path) {
  std::error_code error;
  return is_null_device(path) ||
         (std::filesystem::exists(path, error) && !std::filesystem::is_regular_file(path, error));
}

bool is_standard_output(const std::filesystem::path& /*path*/) { return false; }

void check_writable(const std::filesystem::path& path) { check_target(path); }

void write_file_atomically(const std::filesystem::path& path, std::span<const std::uint8_t> bytes) {
  check_target(path);
  if (is_null_device(path)) return;
  const std::filesystem::path target = end_of_links(path);
  const std::filesystem::path draft =
      folder_of(target) / (".texmap-" + std::to_string(std::random_device()()));
  try {
    write_new_file(draft, bytes);
    rename_over(draft, target);
  } catch (const FileError&) {
    DeleteFileW(draft.c_str());
    throw;
  }
}

std::filesystem::path program_folder() {
  std::wstring path(32768, L'\0');
  const DWORD length = GetModuleFileNameW(nullptr, path.data(), static_cast<DWORD>(path.size()));
  path.resize(length);
  return std::filesystem::path(path).parent_path();
}

std::filesystem::path folder_in_environment(const char* variable) {
  const wchar_t* const folder = _wgetenv(path_of(variable).c_str());
  return folder == nullptr ? L"" : folder;
}

double thread_milliseconds() {  // GetThreadTimes counts in steps of 16 ms
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double, std::milli>(now).count();
}

std::uint64_t free_memory() {
  MEMORYSTATUSEX status{};
  status.dwLength = sizeof status;
  return GlobalMemoryStatusEx(&status) != 0 ? status.ullAvailPageFile : ~std::uint64_t{0};
}

std::string processor_name() {
  const char* const name = std::getenv("PROCESSOR_IDENTIFIER");
  return name == nullptr ? "unknown" : name;
}

double system_load() { return -1; }

bool stderr_is_watched() {
  DWORD mode = 0;
  return GetConsoleMode(GetStdHandle(STD_ERROR_HANDLE), &mode) != 0;
}

std::vector<std::string> typed_words(int, const char* const*) {
  // argv is in the code page of the system, which lacks most letters.
  int count = 0;
  wchar_t** const typed = CommandLineToArgvW(GetCommandLineW(), &count);
  if (typed == nullptr) throw std::bad_alloc();
  std::vector<std::string> words;
  for (int i = 1; i < count; ++i) words.push_back(name_of(typed[i]));
  LocalFree(typed);
  return words;
}

void secure_standard_streams() {
  // What is printed is UTF-8, and the same bytes as on other systems.
  SetConsoleOutputCP(CP_UTF8);
  for (std::FILE* const stream : {stdin, stdout, stderr}) {
    const bool open = _fileno(stream) >= 0 && _get_osfhandle(_fileno(stream)) >= 0;
    if (!open && std::freopen("NUL", stream == stdin ? "r" : "w", stream) == nullptr) continue;
    _setmode(_fileno(stream), _O_BINARY);
  }
}

void end_with(std::string_view message) {
  DWORD written = 0;
  WriteFile(GetStdHandle(STD_ERROR_HANDLE), message.data(), static_cast<DWORD>(message.size()),
            &written, nullptr);
  _exit(1);
}

}  // namespace texmap
