package org.mechservice.sim.service.limits;

import java.util.Arrays;
import java.util.Optional;
import org.mechservice.idl.LimitExceeded;
import org.mechservice.idl.MAX_MECHML_BYTES;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * The limits of a host, each with its name, unit, default and the code of the error catalogue for
 * its refusals.
 */
public enum HostLimit {
  /** A client renews at a third of it, so two renewals may be lost. */
  LEASE(
      "lease", "s", 120, 1, MessageCode.LIMIT_EXCEEDED, "a session lives this long without a call"),
  /** This and the next limit keep one client from taking all memory. */
  SESSIONS("sessions", "1", 200, 0, MessageCode.TOO_MANY_SESSIONS, "sessions on one host at once"),
  /** Of four clients that take all they get, the last still gets in. */
  CLIENT_SESSIONS(
      "clientSessions",
      "1",
      48,
      0,
      MessageCode.TOO_MANY_SESSIONS,
      "sessions of one client on one host at once"),
  /** Half of the processors, so that one client leaves some to the others. */
  CLIENT_BUILDS(
      "clientBuilds",
      "1",
      Math.max(1, Runtime.getRuntime().availableProcessors() / 2),
      1,
      MessageCode.TOO_MANY_BUILDS,
      "models of one client that are read or built at once"),
  /** Twenty times what 50 000 bodies take; somebody waits for the answer. */
  SET_UP_TIME(
      "setUpTime",
      "s",
      600,
      1,
      MessageCode.SET_UP_TOO_LONG,
      "time in which one model is read or built"),
  /** Twice what 50 000 bodies take. */
  SET_UP_MEMORY(
      "setUpMemory",
      "B",
      2L << 30,
      1 << 26,
      MessageCode.OUT_OF_MEMORY,
      "heap of one process in which models are read and built"),
  /** Five times as many as the largest that were measured. */
  MODEL_LOOPS(
      "modelLoops", "1", 20_000, 0, MessageCode.MODEL_TOO_LARGE, "closed loops of one model"),
  /** Ten of the largest. */
  CLIENT_MODEL_BYTES(
      "clientModelBytes",
      "B",
      10L * MAX_MECHML_BYTES.value,
      1,
      MessageCode.MODEL_TOO_LARGE,
      "size of the models of all sessions and simulations of one client"),
  SIMULATIONS(
      "simulations",
      "1",
      64,
      0,
      MessageCode.TOO_MANY_SIMULATIONS,
      "simulations of one session at once"),
  CLIENT_RUNS(
      "clientRuns",
      "1",
      64,
      0,
      MessageCode.TOO_MANY_RUNS,
      "runs of one client on one host at once"),
  /** As many as all others, so that no client takes the room for what others left. */
  CLIENT_KEPT(
      "clientKept",
      "1",
      1000,
      0,
      MessageCode.LIMIT_EXCEEDED,
      "ended runs of one client that are kept; the oldest go first"),
  CURSORS(
      "cursors",
      "1",
      16,
      0,
      MessageCode.TOO_MANY_CURSORS,
      "open cursors of one simulation at once"),
  QUEUE("queue", "1", 1000, 0, MessageCode.QUEUE_FULL, "runs that wait for a place on one host"),
  MODEL_BYTES(
      "modelBytes",
      "B",
      MAX_MECHML_BYTES.value,
      1,
      MessageCode.MODEL_TOO_LARGE,
      "size of a model with its user files"),
  /** Half a million rows of 1000 columns. */
  RESULT_BYTES(
      "resultBytes",
      "B",
      4L << 30,
      1,
      MessageCode.RESULTS_TOO_LARGE,
      "size of the rows of one run"),
  SPOOL_BYTES(
      "spoolBytes",
      "B",
      256L << 30,
      1,
      MessageCode.SPOOL_FULL,
      "size of the rows of all runs of one host"),
  CLIENT_SPOOL_BYTES(
      "clientSpoolBytes",
      "B",
      64L << 30,
      1,
      MessageCode.SPOOL_FULL,
      "size of the rows of all runs of one client"),
  /** Enough for the system to go on; rows of runs are not worth a full disk. */
  FREE_DISK(
      "freeDisk",
      "B",
      1L << 30,
      0,
      MessageCode.DISK_FULL,
      "space on the disk of the rows that runs leave free"),
  /** A day: an abandoned run then gives its place back. */
  WALL_TIME(
      "wallTime", "s", 86_400, 1, MessageCode.RUN_TOO_LONG, "time one run takes, without pauses"),
  CPU_TIME(
      "cpuTime", "s", 86_400, 1, MessageCode.PROCESSOR_TIME_EXCEEDED, "processor time of one run"),
  /** What is in use after a collection; with less left, collections take all the time. */
  MEMORY(
      "memory",
      "B",
      Runtime.getRuntime().maxMemory() / 10 * 9,
      1,
      MessageCode.OUT_OF_MEMORY,
      "heap of one host"),
  /** Enough for the largest model of the examples; many workers fit on one machine. */
  WORKER_MEMORY(
      "workerMemory",
      "B",
      1L << 30,
      1 << 24,
      MessageCode.OUT_OF_MEMORY,
      "heap of one process for classes of users"),
  CONNECTIONS(
      "connections",
      "1",
      280,
      1,
      MessageCode.TOO_MANY_CONNECTIONS,
      "connections to one process at once"),
  /** A week, so that results of Friday are there on Monday. */
  RETENTION(
      "retention",
      "s",
      7 * 86_400,
      0,
      MessageCode.LIMIT_EXCEEDED,
      "an ended run is kept this long");

  private final String label;
  private final String unit;
  private final long initial;
  private final long least;
  private final MessageCode code;
  private final String text;

  HostLimit(String label, String unit, long initial, long least, MessageCode code, String text) {
    this.label = label;
    this.unit = unit;
    this.initial = initial;
    this.least = least;
    this.code = code;
    this.text = text;
  }

  /** Returns the limit of a name, if there is one. */
  public static Optional<HostLimit> named(String label) {
    return Arrays.stream(values()).filter(limit -> limit.label.equals(label)).findFirst();
  }

  /** Returns the name operators and clients see. */
  public String label() {
    return label;
  }

  String unit() {
    return unit;
  }

  long initial() {
    return initial;
  }

  /** Returns the smallest value that makes sense. */
  long least() {
    return least;
  }

  /** Returns the entry of the error catalogue for what is beyond it. */
  public MessageCode code() {
    return code;
  }

  /** Returns what it bounds. */
  String text() {
    return text;
  }

  /**
   * Returns a refusal.
   *
   * @param value value allowed
   * @param requested value requested
   * @param message the request, and advice
   */
  public LimitExceeded refusal(long value, long requested, String message) {
    return new LimitExceeded(code.code(), message, label, value, requested);
  }
}
