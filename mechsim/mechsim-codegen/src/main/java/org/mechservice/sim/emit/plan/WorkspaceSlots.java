package org.mechservice.sim.emit.plan;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;
import org.mechservice.sim.emit.method.ValueUsage;
import org.mechservice.solver.symbol.Program;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarOperation;

/**
 * Assigns an element of the workspace to each value that is used in several methods; an element is
 * reused after the last method that reads it. Sines and cosines come first.
 */
final class WorkspaceSlots {
  private final Map<Scalar, Integer> slotOf = new HashMap<>();
  private final TreeSet<Integer> free = new TreeSet<>();
  private final List<List<Integer>> freedAfter = new ArrayList<>();
  private final ValueUsage usage;
  private final int[] chunkOfSection;
  private int count;

  /**
   * @param chunkOfSection method of each section; not modified
   * @param reuse whether elements are reused; otherwise the values of a section are contiguous and
   *     in order, equally for all equal sections
   */
  WorkspaceSlots(Program program, ValueUsage usage, int[] chunkOfSection, boolean reuse) {
    this.usage = usage;
    this.chunkOfSection = chunkOfSection;
    for (int section = 0; section <= chunkOfSection.length; section++) {
      freedAfter.add(new ArrayList<>());
    }
    giveAngles();
    int chunk = 0;
    for (int section = 0; section < program.sections().size(); section++) {
      for (; chunk < chunkOfSection[section]; chunk++) {
        if (reuse) {
          free.addAll(freedAfter.get(chunk));
        }
      }
      for (Scalar node : usage.placedIn(section)) {
        int last = lastChunkUsing(node);
        if (last > chunk) {
          give(node, last);
        }
      }
    }
  }

  private void giveAngles() {
    Map<Scalar, Integer> number = new HashMap<>();
    for (Scalar angle : usage.angles()) {
      number.put(angle, number.size());
    }
    for (Scalar node : usage.given()) {
      if (ValueUsage.isAngleFunction(node)) {
        int angle = number.getOrDefault(node.first(), -1);
        int slot = 2 * angle + (node.operation() == ScalarOperation.SINE ? 0 : 1);
        slotOf.put(node, slot);
        freedAfter.get(lastChunkUsing(node)).add(slot);
      }
    }
    count = 2 * usage.angles().size();
  }

  private void give(Scalar node, int lastChunk) {
    Integer slot = free.pollFirst();
    if (slot == null) {
      slot = count++;
    }
    slotOf.put(node, slot);
    freedAfter.get(lastChunk).add(slot);
  }

  private int lastChunkUsing(Scalar node) {
    int last = 0;
    for (int i = 0; i < usage.useCount(node); i++) {
      last = Math.max(last, chunkOfSection[usage.user(node, i)]);
    }
    return last;
  }

  boolean has(Scalar node) {
    return slotOf.containsKey(node);
  }

  /** Returns the element of a value that has one. */
  int of(Scalar node) {
    return slotOf.getOrDefault(node, -1);
  }

  /** Returns the length of workspace needed. */
  int count() {
    return count;
  }
}
