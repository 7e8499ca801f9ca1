package org.mechservice.sim.emit.bytes;

import org.mechservice.sim.scene.ModelBuildException;
import org.mechservice.solver.catalogue.MessageCode;
import org.objectweb.asm.ClassReader;

/** Lengths of the methods of a class file, read from their Code attributes (JVMS §4.7.3). */
public final class MethodSizes {
  /**
   * Largest size of a method that the virtual machine compiles
   * (docs/theory/formulations.md#methods).
   */
  private static final int LONGEST = 8000;

  private final ClassReader reader;
  private final char[] buffer;
  private int longest;

  private MethodSizes(byte[] classFile) {
    reader = new ClassReader(classFile);
    buffer = new char[reader.getMaxStringLength()];
  }

  /**
   * Rejects a class that would run slowly.
   *
   * @throws ModelBuildException S-085 if a method is too long for compilation by the virtual
   *     machine
   */
  public static void requireCompilable(byte[] classFile) {
    int longest = longest(classFile);
    if (longest >= LONGEST) {
      throw new ModelBuildException(
          MessageCode.MODEL_CLASS_TOO_LARGE,
          "a method of the generated class is too large ("
              + longest
              + " bytes, the limit is "
              + LONGEST
              + "); use fewer bodies");
    }
  }

  /** Returns the bytes of code of the longest method. */
  public static int longest(byte[] classFile) {
    MethodSizes sizes = new MethodSizes(classFile);
    sizes.read();
    return sizes.longest;
  }

  private void read() {
    // access_flags, this_class, super_class, interfaces_count, interfaces, fields, methods
    int at = reader.header + 6;
    at += 2 + 2 * reader.readUnsignedShort(at);
    at = members(at);
    members(at);
  }

  /** Reads fields or methods and returns the index after them. */
  private int members(int start) {
    int count = reader.readUnsignedShort(start);
    int at = start + 2;
    for (int member = 0; member < count; member++) {
      int attributes = reader.readUnsignedShort(at + 6);
      at += 8;
      for (int attribute = 0; attribute < attributes; attribute++) {
        if ("Code".equals(reader.readUTF8(at, buffer))) {
          // attribute_name_index, attribute_length, max_stack, max_locals, code_length
          longest = Math.max(longest, reader.readInt(at + 10));
        }
        at += 6 + reader.readInt(at + 2);
      }
    }
    return at;
  }
}
