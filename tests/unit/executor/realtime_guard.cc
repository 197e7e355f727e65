#include "tests/unit/executor/realtime_guard.h"

#include <dlfcn.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <pthread.h>
#include <semaphore.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <cstddef>
#include <cstdlib>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define GOALNET_SANITIZED 1
#else
#define GOALNET_SANITIZED 0
#endif

namespace {

thread_local bool watching = false;
thread_local const char* caught = nullptr;

}  // namespace

#if !GOALNET_SANITIZED

namespace {

void forbidden(const char* name) {
  if (watching && caught == nullptr) caught = name;
}

template <class Function>
Function original(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

}  // namespace

// Each replacement notes the call and passes it on. glibc offers its allocator under a second name, which
// avoids asking dlsym (which allocates) for malloc.
extern "C" {
void* __libc_malloc(std::size_t);
void __libc_free(void*);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);

void* malloc(std::size_t size) {
  forbidden("malloc");
  return __libc_malloc(size);
}
void free(void* block) {
  forbidden("free");
  __libc_free(block);
}
void* calloc(std::size_t count, std::size_t size) {
  forbidden("calloc");
  return __libc_calloc(count, size);
}
void* realloc(void* block, std::size_t size) {
  forbidden("realloc");
  return __libc_realloc(block, size);
}
void* memalign(std::size_t alignment, std::size_t size) {
  forbidden("memalign");
  return __libc_memalign(alignment, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
  forbidden("aligned_alloc");
  return __libc_memalign(alignment, size);
}

#define GOALNET_WATCH(result, name, parameters, arguments)          \
  result name parameters {                                          \
    static const auto real = original<result(*) parameters>(#name); \
    forbidden(#name);                                               \
    return real arguments;                                          \
  }
GOALNET_WATCH(int, pthread_mutex_lock, (pthread_mutex_t * m) noexcept, (m))
GOALNET_WATCH(int, pthread_mutex_trylock, (pthread_mutex_t * m) noexcept, (m))
GOALNET_WATCH(int, pthread_rwlock_rdlock, (pthread_rwlock_t * l) noexcept, (l))
GOALNET_WATCH(int, pthread_rwlock_wrlock, (pthread_rwlock_t * l) noexcept, (l))
GOALNET_WATCH(int, pthread_cond_signal, (pthread_cond_t * c) noexcept, (c))
GOALNET_WATCH(int, pthread_cond_wait, (pthread_cond_t * c, pthread_mutex_t* m), (c, m))
GOALNET_WATCH(int, sem_post, (sem_t * s) noexcept, (s))
GOALNET_WATCH(int, sem_wait, (sem_t * s), (s))
GOALNET_WATCH(ssize_t, write, (int f, const void* b, std::size_t n), (f, b, n))
GOALNET_WATCH(int, clock_gettime, (clockid_t c, timespec* t) noexcept, (c, t))
}

#endif

namespace goalnet::executor::test {

bool watches_heap_and_locks() { return !GOALNET_SANITIZED; }

std::string first_forbidden_call(const std::function<void()>& function) {
  caught = nullptr;
  watching = true;
  function();
  watching = false;
  return caught == nullptr ? "" : caught;
}

bool runs_without_system_calls(const std::function<void()>& function) {
  const pid_t child = fork();
  if (child == 0) {
    // Everything but the exit itself kills the process.
    sock_filter rules[] = {
        BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_exit_group, 0, 1),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_KILL_PROCESS),
    };
    const sock_fprog program{sizeof rules / sizeof rules[0], rules};
    if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) _exit(2);
    if (prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) != 0) _exit(3);
    function();
    syscall(SYS_exit_group, 0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace goalnet::executor::test
