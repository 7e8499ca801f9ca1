package org.mechservice.sim.emit;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.spatial.NumberTable;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.Type;

/** The constants in which calls of one method differ, packed into one table of the class. */
final class ConstantTable {
  /** What reads it. */
  static final Class<?> READER = NumberTable.class;

  /** What methods call it. */
  static final String NAME = "c";

  /** What the class calls it. */
  static final String FIELD = "CONSTANTS";

  /** Characters of a text: a class file holds up to 65535 bytes in one. */
  private static final int LONGEST_TEXT = 16_000;

  private final List<Double> numbers = new ArrayList<>();

  /** Appends numbers and returns where the first of them is. */
  int add(List<Double> row) {
    numbers.addAll(row);
    return numbers.size() - row.size();
  }

  /** Drops what was added beyond a size. */
  void cutBack(int size) {
    numbers.subList(size, numbers.size()).clear();
  }

  boolean isEmpty() {
    return numbers.isEmpty();
  }

  int size() {
    return numbers.size();
  }

  private List<String> texts() {
    List<String> texts = new ArrayList<>();
    NumberText decimals = new NumberText();
    StringBuilder text = new StringBuilder();
    for (double number : numbers) {
      if (text.length() > LONGEST_TEXT) {
        texts.add(text.toString());
        text.setLength(0);
      }
      text.append(decimals.of(number)).append(' ');
    }
    texts.add(text.toString());
    return texts;
  }

  /** Writes the field of a class. */
  void write(SourceLines source) {
    List<String> texts = texts();
    source.line("private static final double[] " + FIELD + " =");
    source.line("    NumberTable.of(");
    source.line("        " + numbers.size() + ",");
    for (int i = 0; i < texts.size(); i++) {
      String end = i + 1 < texts.size() ? "," : ");";
      source.line("        " + JavaText.literal(texts.get(i)) + end);
    }
  }

  /** Writes the same into a class file. */
  void write(ClassVisitor file, String className) {
    int access = Opcodes.ACC_PRIVATE | Opcodes.ACC_STATIC | Opcodes.ACC_FINAL;
    file.visitField(access, FIELD, "[D", null, null).visitEnd();
    MethodVisitor code = ClassMethods.begin(file, Opcodes.ACC_STATIC, "<clinit>", "()V");
    NumberCode push = new NumberCode(code);
    List<String> texts = texts();
    push.push(numbers.size());
    push.push(texts.size());
    code.visitTypeInsn(Opcodes.ANEWARRAY, "java/lang/String");
    for (int i = 0; i < texts.size(); i++) {
      code.visitInsn(Opcodes.DUP);
      push.push(i);
      code.visitLdcInsn(texts.get(i));
      code.visitInsn(Opcodes.AASTORE);
    }
    String owner = Type.getInternalName(READER);
    String descriptor = "(I[Ljava/lang/String;)[D";
    code.visitMethodInsn(Opcodes.INVOKESTATIC, owner, "of", descriptor, false);
    code.visitFieldInsn(Opcodes.PUTSTATIC, className, FIELD, "[D");
    ClassMethods.end(code, Opcodes.RETURN);
  }
}
