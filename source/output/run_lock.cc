// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/output/run_lock.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/vfs.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <ctime>
#include <fstream>
#include <iterator>
#include <sstream>
#include <thread>

namespace lumbricus
{
  namespace
  {
    const std::string lock_line =
      "A run of lumbricus writes to this folder and has locked it.";

    // Of the two bytes that are locked the first is that of the rank that owns
    // the file, the second that of all ranks.
    constexpr off_t of_owner = 0;
    constexpr off_t of_all   = 1;

    enum class KernelLock
    {
      taken,
      busy,
      unsupported
    };



    KernelLock
    lock(const int file, const short type, const off_t begin, const off_t n)
    {
      struct flock request = {};
      request.l_type       = type;
      request.l_whence     = SEEK_SET;
      request.l_start      = begin;
      request.l_len        = n;
      if (fcntl(file, F_OFD_SETLK, &request) == 0)
        return KernelLock::taken;
      return errno == EAGAIN || errno == EACCES ? KernelLock::busy :
                                                  KernelLock::unsupported;
    }



    // Whether locks on it reach all who can write to it: no network is between.
    bool
    is_on_this_machine(const int file)
    {
      // ext2 to ext4, XFS, Btrfs, tmpfs, overlay, ZFS, F2FS, bcachefs: see
      // statfs(2).
      const std::array<unsigned long, 8> known = {{0xEF53,
                                                   0x58465342,
                                                   0x9123683E,
                                                   0x01021994,
                                                   0x794C7630,
                                                   0x2FC12FC1,
                                                   0xF2F52010,
                                                   0xCA451A4E}};
      struct statfs                      of_file;
      return fstatfs(file, &of_file) == 0 &&
             std::count(known.begin(),
                        known.end(),
                        static_cast<unsigned long>(of_file.f_type) &
                          0xFFFFFFFF) > 0;
    }



    // Whether @p path still is the file that is open, not a later one.
    bool
    is_still(const std::string &path, const int file)
    {
      struct stat now, then;
      return stat(path.c_str(), &now) == 0 && fstat(file, &then) == 0 &&
             now.st_dev == then.st_dev && now.st_ino == then.st_ino;
    }



    std::string
    content_of(const int file)
    {
      std::array<char, 1024> content;
      const auto n = pread(file, content.data(), content.size(), 0);
      return n > 0 ? std::string(content.data(), n) : "";
    }



    // Where the disk becomes full the first part is written, and only the rest
    // fails.
    bool
    write_all(const int file, const std::string &text)
    {
      std::size_t n_written = 0;
      while (n_written < text.size())
        {
          const auto n = pwrite(file,
                                text.data() + n_written,
                                text.size() - n_written,
                                n_written);
          if (n < 0)
            return false;
          n_written += n;
        }
      return true;
    }



    // The first line of a file of the kernel's.
    std::string
    line_of(const std::string &file_name)
    {
      std::ifstream in(file_name);
      std::string   line;
      std::getline(in, line);
      return line;
    }



    // When a process was started: the 22nd word of its status, the second of
    // which, in parentheses, may have blanks. Empty where there is none.
    std::string
    start_of(const std::string &process)
    {
      const std::string status = line_of("/proc/" + process + "/stat");
      const auto        name   = status.rfind(')');
      if (name == std::string::npos)
        return "";
      std::istringstream words(status.substr(name + 1));
      constexpr int      n_words_after_name = 20;
      std::string        word;
      for (int i = 0; i < n_words_after_name; ++i)
        words >> word;
      return word;
    }



    std::string
    host_name()
    {
      std::array<char, 256> name = {};
      gethostname(name.data(), name.size() - 1);
      return name.data();
    }



    std::string
    boot_id()
    {
      return line_of("/proc/sys/kernel/random/boot_id");
    }
  } // namespace



  const std::string RunLock::file_name = "lumbricus.lock";



  RunLock::RunLock(const std::string &folder, const MPI_Comm comm)
    : folder(folder)
    , path(folder + "/" + file_name)
    , is_first(dealii::Utilities::MPI::this_mpi_process(comm) == 0)
  {
    const std::string reason = is_first ? take() : "";
    throw_on_all_ranks<ExcInput>(reason, comm);
    if (is_first)
      return;
    // Where this is not possible the first rank speaks for all.
    file = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW);
    if (file >= 0)
      lock(file, F_RDLCK, of_all, 1);
  }



  RunLock::~RunLock()
  {
    if (taken && is_still(path, file))
      unlink(path.c_str());
    if (file >= 0)
      close(file);
  }



  std::string
  RunLock::take()
  {
    using namespace std::chrono_literals;
    const std::string cannot_be_written =
      "The output folder '" + folder + "' cannot be written: ";
    const std::string advice =
      " Choose another with 'Output/Folder' or --output.";

    // When mpirun ends, or one rank, the others live on for a while.
    constexpr int n_tries = 100;
    KernelLock    state   = KernelLock::busy;
    for (int i = 0; i < n_tries && state == KernelLock::busy; ++i)
      {
        if (file >= 0)
          close(file);
        file = open(path.c_str(),
                    O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK,
                    0666);
        if (file < 0)
          return cannot_be_written + std::strerror(errno) + "." + advice;

        state = lock(file, F_WRLCK, of_owner, 1);
        if (state == KernelLock::busy)
          return refusal(content_of(file), false);
        if (state == KernelLock::taken)
          state = lock(file, F_WRLCK, of_all, 1);
        if (state != KernelLock::busy && !is_still(path, file))
          state = KernelLock::busy; // the one before has just ended
        else if (state == KernelLock::busy)
          std::this_thread::sleep_for(100ms);
      }
    const std::string content = content_of(file);
    if (state == KernelLock::busy)
      return refusal(content, false);
    // A run that was killed may have written a part of it.
    const auto n = std::min(content.size(), lock_line.size());
    if (content.compare(0, n, lock_line, 0, n) != 0)
      return "The file '" + path +
             "' is not from a run, which would overwrite it. Move it away, or "
             "choose another folder with 'Output/Folder' or --output.";

    const LockHolder holder = LockHolder::read(content);
    if (!holder.host.empty() && !holder.has_ended() &&
        !(state == KernelLock::taken && is_on_this_machine(file)))
      return refusal(content, true);

    const std::string own = LockHolder::this_process().text();
    if (ftruncate(file, 0) != 0 || !write_all(file, own))
      {
        const std::string reason = std::strerror(errno);
        unlink(path.c_str());
        return cannot_be_written + reason + "." + advice;
      }
    if (state == KernelLock::taken)
      lock(file, F_RDLCK, of_all, 1); // so that the other ranks can
    taken = true;
    return "";
  }



  std::string
  RunLock::refusal(const std::string &content, const bool may_be_stale) const
  {
    const LockHolder holder = LockHolder::read(content);
    const std::string who =
      holder.host.empty() ?
        "another run" :
        "process " + holder.process + " on '" + holder.host + "', since " +
          holder.since + ",";
    return "The output folder '" + folder + "' is in use: " + who +
           " writes there. Wait until that has ended or end it, or choose "
           "another folder with 'Output/Folder' or --output." +
           (may_be_stale ? " If it was killed, remove the file '" + path +
                             "', which it has left." :
                           "");
  }



  LockHolder
  LockHolder::this_process()
  {
    LockHolder holder;
    holder.host    = host_name();
    holder.boot    = boot_id();
    holder.process = std::to_string(getpid());
    holder.start   = start_of(holder.process);

    const std::time_t    now  = std::time(nullptr);
    std::array<char, 32> text = {};
    std::tm              local;
    if (localtime_r(&now, &local) != nullptr)
      std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M:%S", &local);
    holder.since = text.data();
    return holder;
  }



  LockHolder
  LockHolder::read(const std::string &content)
  {
    std::istringstream lines(content);
    std::string        line;
    LockHolder         holder;
    if (!std::getline(lines, line) || line != lock_line)
      return holder;
    while (std::getline(lines, line))
      {
        const auto        blank = std::min(line.find(' '), line.size());
        const std::string value =
          line.substr(std::min(blank + 1, line.size()));
        const std::string item = line.substr(0, blank);
        (item == "host"    ? holder.host :
         item == "boot"    ? holder.boot :
         item == "process" ? holder.process :
         item == "start"   ? holder.start :
                             holder.since) = value;
      }
    return holder;
  }



  std::string
  LockHolder::text() const
  {
    return lock_line + "\nhost " + host + "\nboot " + boot + "\nprocess " +
           process + "\nstart " + start + "\nsince " + since + "\n";
  }



  bool
  LockHolder::has_ended() const
  {
    const bool is_number =
      !process.empty() &&
      std::all_of(process.begin(), process.end(), [](const char c) {
        return c >= '0' && c <= '9';
      });
    return host == host_name() && is_number &&
           (boot != boot_id() || start != start_of(process));
  }
} // namespace lumbricus
