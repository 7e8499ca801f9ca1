package org.mechservice.sim.emit.plan;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.sim.emit.method.CodeSize;
import org.mechservice.sim.emit.method.ValueUsage;
import org.mechservice.solver.symbol.Program;
import org.mechservice.solver.symbol.Scalar;

/**
 * Divides sections that are too long for a method, without changing the order of operations.
 *
 * <p>An output value that was written out at its output gets a variable if its computation moves to
 * another part. Parts are divided again until none is too long.
 */
final class SectionSplitter {
  /** Largest number of outputs of one part. */
  private static final int OUTPUTS = 200;

  private final Program program;
  private final ValueUsage usage;
  private final int partBytes;
  private final List<Program.Section> parts = new ArrayList<>();

  private SectionSplitter(Program program, ValueUsage usage, int partBytes) {
    this.program = program;
    this.usage = usage;
    this.partBytes = partBytes;
  }

  /**
   * Returns a program without long sections.
   *
   * @param longest bytes of code a section may have
   */
  static Division divided(Program program, int longest) {
    Division whole = new Division(program);
    Division parts = whole.divided(longest);
    while (parts.bytes.length > whole.bytes.length) {
      whole = parts;
      parts = whole.divided(longest);
    }
    return whole;
  }

  /** A program in sections, with the uses of its values and the lengths of its sections. */
  static final class Division {
    private final Program program;
    private final ValueUsage usage;
    private final int[] bytes;

    private Division(Program program) {
      this.program = program;
      this.usage = new ValueUsage(program);
      this.bytes = CodeSize.ofSections(program, usage);
    }

    Program program() {
      return program;
    }

    ValueUsage usage() {
      return usage;
    }

    /** Returns an estimate of the code of each section; not to be modified. */
    int[] bytes() {
      return bytes;
    }

    private Division divided(int longest) {
      SectionSplitter division = new SectionSplitter(program, usage, longest / 2);
      boolean any = false;
      for (int s = 0; s < bytes.length; s++) {
        if (bytes[s] <= longest) {
          division.parts.add(program.sections().get(s));
        } else {
          division.divide(s);
          any = true;
        }
      }
      return any ? new Division(program.in(division.parts)) : this;
    }
  }

  private void divide(int s) {
    Program.Section section = program.sections().get(s);
    int filled = 0;
    add(section, section.title(), section.firstNode(), List.of(), List.of());
    for (Scalar node : usage.placedIn(s)) {
      int bytes = CodeSize.ofValue(usage, node);
      if (filled > 0 && filled + bytes > partBytes) {
        add(section, "", node.id(), List.of(), List.of());
        filled = 0;
      }
      filled += bytes;
    }
    putOut(section, endOf(s));
  }

  /** Writes outputs and checks after all values, in parts without values. */
  private void putOut(Program.Section section, int end) {
    List<Program.Output> outputs = section.outputs();
    int together = Math.min(OUTPUTS, partBytes / CodeSize.OUTPUT);
    for (int i = 0; i < outputs.size(); i += together) {
      int next = Math.min(i + together, outputs.size());
      add(section, "", end, outputs.subList(i, next), List.of());
    }
    List<Program.Guard> guards = section.guards();
    int checks = partBytes / CodeSize.GUARD;
    for (int i = 0; i < guards.size(); i += checks) {
      int next = Math.min(i + checks, guards.size());
      add(section, "", end, List.of(), guards.subList(i, next));
    }
  }

  private int endOf(int s) {
    return s + 1 < program.sections().size()
        ? program.sections().get(s + 1).firstNode()
        : program.expressions().size();
  }

  private void add(
      Program.Section section,
      String title,
      int firstNode,
      List<Program.Output> outputs,
      List<Program.Guard> guards) {
    parts.add(
        new Program.Section(
            title, section.subject(), firstNode, outputs, guards, section.readsAnew()));
  }
}
