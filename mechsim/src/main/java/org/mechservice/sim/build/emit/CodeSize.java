package org.mechservice.sim.build.emit;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;
import org.mechservice.sim.symbolic.Program;
import org.mechservice.sim.symbolic.Scalar;

/** Estimates bytes of code. */
final class CodeSize {
  private static final int SLOT = 5;
  private static final int CONSTANT = 3;
  private static final int CHECK = 10;

  /** What a local variable takes before it is known which. */
  private static final int LOCAL = 3;

  /** Local variables up to this slot take the short form, two bytes an access, others four. */
  private static final int LAST_SHORT_SLOT = 255;

  private static final int SHORT_LOCAL = 2;
  private static final int WIDE_LOCAL = 4;

  /** Slots of the instance, the parameters and the workspace. */
  private static final int FIRST_SLOT = 7;

  private final Map<Scalar, Place> places;
  private final List<String> accesses = new ArrayList<>();
  private int bytes;

  private CodeSize(Map<Scalar, Place> places) {
    this.places = places;
  }

  /** Returns the estimate of each section of a program, were all in one method. */
  static int[] ofSections(Program program, Usage usage) {
    int[] bytes = new int[program.sections().size()];
    for (int s = 0; s < bytes.length; s++) {
      for (Scalar node : usage.placedIn(s)) {
        bytes[s] += LOCAL + sizeIn(usage, node);
      }
      Program.Section section = program.sections().get(s);
      bytes[s] += section.outputs().size() * (SLOT + LOCAL);
      bytes[s] += section.guards().size() * (2 * LOCAL + CHECK);
    }
    return bytes;
  }

  private static int sizeIn(Usage usage, Scalar node) {
    int bytes = 1;
    for (Scalar operand : node.operands()) {
      boolean inline = !operand.operands().isEmpty() && !usage.isPlaced(operand);
      bytes += inline ? sizeIn(usage, operand) : LOCAL;
    }
    return bytes;
  }

  /** Returns the estimate of a planned method, its variables sharing slots as they come and go. */
  static int of(MethodPlan method) {
    CodeSize size = new CodeSize(method.places());
    method.statements().forEach(size::add);
    return size.bytes + size.bytesOfLocals();
  }

  private void add(Statement statement) {
    if (statement instanceof Statement.Load load) {
      add(load.from());
      accesses.add(load.local());
    } else if (statement instanceof Statement.Define define) {
      addOperation(define.value());
      accesses.add(define.local());
    } else if (statement instanceof Statement.Store store) {
      bytes += SLOT;
      add(store.value());
    } else if (statement instanceof Statement.PutOut output) {
      bytes += SLOT;
      add(output.value());
    } else if (statement instanceof Statement.Check check) {
      bytes += CHECK;
      add(check.pivot());
      add(check.bound());
    } else if (statement instanceof Statement.CopyInputs) {
      bytes += CHECK;
    }
  }

  private void add(Scalar node) {
    Place place = places.get(node);
    if (place != null) {
      add(place);
    } else if (node.isConstant()) {
      bytes += CONSTANT;
    } else {
      addOperation(node);
    }
  }

  private void addOperation(Scalar node) {
    bytes += 1;
    node.operands().forEach(this::add);
  }

  private void add(Place place) {
    if (place instanceof Place.Local local) {
      accesses.add(local.name());
    } else {
      bytes += SLOT;
    }
  }

  private int bytesOfLocals() {
    Map<String, Integer> lastAccess = new HashMap<>();
    for (int i = 0; i < accesses.size(); i++) {
      lastAccess.put(accesses.get(i), i);
    }
    Map<String, Integer> slotOf = new HashMap<>();
    TreeSet<Integer> free = new TreeSet<>();
    int next = FIRST_SLOT;
    int total = 0;
    for (int i = 0; i < accesses.size(); i++) {
      String name = accesses.get(i);
      Integer slot = slotOf.get(name);
      if (slot == null) {
        slot = free.pollFirst();
      }
      if (slot == null) {
        slot = next;
        next += 2;
      }
      slotOf.put(name, slot);
      total += slot <= LAST_SHORT_SLOT ? SHORT_LOCAL : WIDE_LOCAL;
      if (lastAccess.getOrDefault(name, -1) == i) {
        free.add(slot);
      }
    }
    return total;
  }
}
