package org.mechservice.guard;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.Optional;

/**
 * The filter of system calls of a confined worker, as a program of the kernel's packet filter
 * (seccomp(2), {@code struct sock_filter} of linux/filter.h).
 *
 * <p>It refuses with EPERM every call that makes a process, opens a socket, or reaches into another
 * process, the kernel or the mounts; memory that no limit counts is refused too. Threads stay
 * allowed: {@code clone} passes with CLONE_THREAD, and {@code clone3}, whose flags a filter cannot
 * read, answers ENOSYS, so that the C library uses {@code clone}. {@code execve} stays allowed: the
 * program that installs the filter starts Java with it; it replaces a process and makes none. A
 * call of another architecture ends the process.
 */
enum SystemCallFilter {
  /** Numbers of asm/unistd_64.h; the calls of its 32-bit pointer variant x32 are refused. */
  X86_64(
      "amd64",
      0xC000003E,
      56,
      new int[] {
        57,
        58,
        322, // fork, vfork, execveat
        41, // socket
        101,
        310,
        311, // ptrace, process_vm_readv, process_vm_writev
        272,
        308,
        161,
        155,
        165,
        166, // namespaces and mounts
        248,
        249,
        250,
        298,
        321,
        323,
        135, // keys, perf_event_open, bpf, userfaultfd, personality
        175,
        176,
        246,
        313,
        320, // kernel modules, kexec
        29,
        64,
        68,
        240,
        319 // shared memory, semaphores, queues, memfd
      }),
  /** Numbers of asm-generic/unistd.h, where fork and vfork do not exist. */
  AARCH64(
      "aarch64",
      0xC00000B7,
      220,
      new int[] {
        281, // execveat
        198, // socket
        117,
        270,
        271, // ptrace, process_vm_readv, process_vm_writev
        97,
        268,
        51,
        41,
        40,
        39, // namespaces and mounts
        217,
        218,
        219,
        241,
        280,
        282,
        92, // keys, perf_event_open, bpf, userfaultfd, personality
        105,
        106,
        104,
        273,
        294, // kernel modules, kexec
        194,
        190,
        186,
        180,
        279 // shared memory, semaphores, queues, memfd
      });

  /** Calls that are newer than their common numbers on all architectures. */
  private static final int[] REFUSED_EVERYWHERE = {
    425,
    426,
    427, // io_uring, which opens sockets past a filter
    428,
    429,
    430,
    431,
    432,
    433,
    442, // mounts
    438, // pidfd_getfd
    447 // memfd_secret
  };

  private static final int CLONE3 = 435;
  private static final int CLONE_THREAD = 0x10000;
  private static final int X32_BIT = 0x40000000;

  // struct seccomp_data: number of the call, architecture, lower half of the first argument
  private static final int CALL_NUMBER = 0;
  private static final int ARCHITECTURE = 4;
  private static final int FIRST_ARGUMENT = 16;

  private static final int ALLOW = 0x7fff0000;
  private static final int KILL_PROCESS = 0x80000000;
  private static final int ERROR = 0x00050000;
  private static final int EPERM = 1;
  private static final int ENOSYS = 38;

  // linux/bpf_common.h: BPF_LD|BPF_W|BPF_ABS, BPF_JMP|BPF_JEQ|BPF_K, ...|BPF_JGE, ...|BPF_JSET,
  // BPF_RET|BPF_K
  private static final short LOAD = 0x20;
  private static final short IF_EQUAL = 0x15;
  private static final short IF_AT_LEAST = 0x35;
  private static final short IF_ANY_BIT = 0x45;
  private static final short RETURN = 0x06;

  private static final int INSTRUCTION_BYTES = 8;

  private final String javaName;
  private final int audit;
  private final int clone;

  @SuppressWarnings("ImmutableEnumChecker") // not modified
  private final int[] refused;

  SystemCallFilter(String javaName, int audit, int clone, int[] refused) {
    this.javaName = javaName;
    this.audit = audit;
    this.clone = clone;
    this.refused = refused;
  }

  /**
   * Returns the filter of an architecture, if there is one.
   *
   * @param javaName value of {@code os.arch}
   */
  static Optional<SystemCallFilter> of(String javaName) {
    for (SystemCallFilter filter : values()) {
      if (filter.javaName.equals(javaName)) {
        return Optional.of(filter);
      }
    }
    return Optional.empty();
  }

  /** Returns the program; both architectures are little-endian. */
  byte[] program() {
    ByteBuffer program =
        ByteBuffer.allocate(
                (15 + 2 * (refused.length + REFUSED_EVERYWHERE.length)) * INSTRUCTION_BYTES)
            .order(ByteOrder.LITTLE_ENDIAN);
    add(program, LOAD, 0, 0, ARCHITECTURE);
    add(program, IF_EQUAL, 1, 0, audit);
    add(program, RETURN, 0, 0, KILL_PROCESS);
    add(program, LOAD, 0, 0, CALL_NUMBER);
    add(program, IF_AT_LEAST, 0, 1, X32_BIT);
    add(program, RETURN, 0, 0, ERROR | ENOSYS);
    add(program, IF_EQUAL, 0, 1, CLONE3);
    add(program, RETURN, 0, 0, ERROR | ENOSYS);
    refuse(program, refused);
    refuse(program, REFUSED_EVERYWHERE);
    add(program, IF_EQUAL, 1, 0, clone);
    add(program, RETURN, 0, 0, ALLOW);
    add(program, LOAD, 0, 0, FIRST_ARGUMENT);
    add(program, IF_ANY_BIT, 1, 0, CLONE_THREAD);
    add(program, RETURN, 0, 0, ERROR | EPERM);
    add(program, RETURN, 0, 0, ALLOW);
    return Arrays.copyOf(program.array(), program.position());
  }

  private static void refuse(ByteBuffer program, int[] numbers) {
    for (int number : numbers) {
      add(program, IF_EQUAL, 0, 1, number);
      add(program, RETURN, 0, 0, ERROR | EPERM);
    }
  }

  /** Adds an instruction; the jumps count the instructions to skip. */
  private static void add(ByteBuffer program, short code, int ifTrue, int ifFalse, int operand) {
    program.putShort(code).put((byte) ifTrue).put((byte) ifFalse).putInt(operand);
  }
}
