package org.mechservice.sim.build.emit;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;
import org.mechservice.sim.symbolic.Operation;
import org.mechservice.sim.symbolic.Program;
import org.mechservice.sim.symbolic.Scalar;

/**
 * Gives values that cross methods an element of the workspace each; an element is given again once
 * the last method that reads it is over. Sines and cosines come first.
 */
final class WorkspaceSlots {
  private final Map<Scalar, Integer> slotOf = new HashMap<>();
  private final TreeSet<Integer> free = new TreeSet<>();
  private final List<List<Integer>> freedAfter = new ArrayList<>();
  private final Usage usage;
  private final List<Integer> chunkOfSection;
  private int count;

  WorkspaceSlots(Program program, Usage usage, List<Integer> chunkOfSection) {
    this.usage = usage;
    this.chunkOfSection = chunkOfSection;
    for (int section = 0; section <= chunkOfSection.size(); section++) {
      freedAfter.add(new ArrayList<>());
    }
    giveAngles();
    int chunk = 0;
    for (int section = 0; section < program.sections().size(); section++) {
      for (; chunk < chunkOfSection.get(section); chunk++) {
        free.addAll(freedAfter.get(chunk));
      }
      for (Scalar node : usage.placedIn(section)) {
        if (lastChunkUsing(node) > chunk) {
          give(node);
        }
      }
    }
  }

  private void giveAngles() {
    List<Scalar> angles = usage.angles();
    for (Scalar node : usage.given()) {
      if (Usage.isAngleFunction(node)) {
        int slot = 2 * angles.indexOf(node.first()) + (node.operation() == Operation.SINE ? 0 : 1);
        slotOf.put(node, slot);
        freedAfter.get(lastChunkUsing(node)).add(slot);
      }
    }
    count = 2 * angles.size();
  }

  private void give(Scalar node) {
    Integer slot = free.pollFirst();
    if (slot == null) {
      slot = count++;
    }
    slotOf.put(node, slot);
    freedAfter.get(lastChunkUsing(node)).add(slot);
  }

  private int lastChunkUsing(Scalar node) {
    int last = 0;
    for (int section : usage.sectionsUsing(node)) {
      last = Math.max(last, chunkOfSection.get(section));
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
