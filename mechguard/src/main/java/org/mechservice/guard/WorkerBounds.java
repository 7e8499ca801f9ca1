package org.mechservice.guard;

/**
 * Limits of the memory and the processor time of a worker.
 *
 * @param heapBytes heap, B; negative: what Java takes by itself
 * @param cpuSeconds processor time of all its threads, s; negative: no bound
 */
public record WorkerBounds(long heapBytes, long cpuSeconds) {
  /** No bounds of its own. */
  public static final WorkerBounds NONE = new WorkerBounds(-1, -1);
}
