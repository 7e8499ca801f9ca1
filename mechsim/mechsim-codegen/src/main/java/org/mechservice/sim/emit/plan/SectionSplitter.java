package org.mechservice.sim.emit.plan;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.sim.emit.method.CodeSize;
import org.mechservice.sim.emit.method.ValueUsage;
import org.mechservice.sim.symbolic.Program;
import org.mechservice.sim.symbolic.Scalar;

/**
 * Divides sections that are too long for a method; the order of operations stays.
 *
 * <p>A value that is put out, written out there while its section was whole, gets a place of its
 * own once it stands in another part: parts are divided again until none is too long.
 */
final class SectionSplitter {
  /** Values that one part puts out at most. */
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

  /** A program in sections, where its values are used, and how long its sections are. */
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

  /** Outputs and checks come behind all values, in parts without values. */
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
