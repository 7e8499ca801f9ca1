package org.mechservice.sim.build.emit;

import java.util.List;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.ModelSource;
import org.mechservice.solver.compact.CompactModel;
import org.objectweb.asm.ClassWriter;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.Type;

/**
 * A model's class in compact form: it holds the mechanism as data, and the solver's data-driven
 * formulations compute with them.
 *
 * @param model what it holds
 */
public record CompactClass(CompactModel model) implements WrittenClass {
  private static final String OBJECT = "java/lang/Object";
  private static final String NOTHING_TO_VOID = "()V";
  private static final String TEXT = "java/lang/String";
  private static final String TEXTS = "[Ljava/lang/String;";
  private static final String LOADER = "Ljava/lang/ClassLoader;";
  private static final String LIST = "Ljava/util/List;";
  private static final String MODEL = Type.getDescriptor(Model.class);

  @Override
  public String simpleName() {
    return JavaText.className(model.mechanism().name());
  }

  @Override
  public String source() {
    SourceLines source = new SourceLines();
    source.line("package " + ModelClass.PACKAGE + ";").blank();
    if (isTunable()) {
      source.line("import java.util.List;");
    }
    source.line("import org.mechservice.solver.api.Model;");
    source.line("import org.mechservice.solver.api.ModelSource;");
    if (isTunable()) {
      source.line("import org.mechservice.solver.api.TunableParameter;");
    }
    source.line("import org.mechservice.solver.compact.CompactModel;").blank();
    source.documentation(
        List.of(
            JavaText.comment("Model \"" + model.mechanism().name() + "\" in compact form: data.")));
    source.open("public final class " + simpleName() + " implements ModelSource");
    source.line("@Override").open("public Model model()");
    source.line("return CompactModel.model(" + simpleName() + ".class.getClassLoader(), texts());");
    source.close();
    if (isTunable()) {
      source.blank().line("@Override").open("public List<TunableParameter> parameters()");
      source.line("return CompactModel.parameters(texts());");
      source.close();
      source.blank().line("@Override").open("public Model model(double[] values)");
      source.line("return CompactModel.model(");
      source.line("    " + simpleName() + ".class.getClassLoader(), values, texts());");
      source.close();
    }
    source.blank().open("private static String[] texts()");
    source.line("return new String[] {");
    for (String text : model.texts()) {
      source.line("  " + literal(text) + ",");
    }
    source.line("};");
    source.close();
    return source.close().toString();
  }

  private boolean isTunable() {
    return !model.mechanism().parameters().isEmpty();
  }

  /** Returns a literal of one line, whatever its length; data are not there to be read. */
  private static String literal(String text) {
    StringBuilder literal = new StringBuilder("\"");
    for (int i = 0; i < text.length(); i++) {
      char c = text.charAt(i);
      if (c >= ' ' && c < 0x7f && c != '"' && c != '\\') {
        literal.append(c);
      } else {
        // Octal, not Unicode, escapes: the compiler reads those before it knows of literals.
        literal.append('\\').append(Integer.toOctalString(01000 | c).substring(1));
      }
    }
    return literal.append('"').toString();
  }

  @Override
  public byte[] classFile() {
    String name = (ModelClass.PACKAGE + "." + simpleName()).replace('.', '/');
    ClassWriter file = new ClassWriter(ClassWriter.COMPUTE_MAXS);
    file.visit(
        Opcodes.V17,
        Opcodes.ACC_PUBLIC | Opcodes.ACC_FINAL | Opcodes.ACC_SUPER,
        name,
        null,
        OBJECT,
        new String[] {Type.getInternalName(ModelSource.class)});
    constructor(file);
    texts(file);
    method(file, name, "model", "()" + MODEL, "(" + LOADER + TEXTS + ")" + MODEL);
    if (isTunable()) {
      method(file, name, "model", "([D)" + MODEL, "(" + LOADER + "[D" + TEXTS + ")" + MODEL);
      method(file, name, "parameters", "()" + LIST, "(" + TEXTS + ")" + LIST);
    }
    file.visitEnd();
    return file.toByteArray();
  }

  private static void constructor(ClassWriter file) {
    MethodVisitor code =
        file.visitMethod(Opcodes.ACC_PUBLIC, "<init>", NOTHING_TO_VOID, null, null);
    code.visitCode();
    code.visitVarInsn(Opcodes.ALOAD, 0);
    code.visitMethodInsn(Opcodes.INVOKESPECIAL, OBJECT, "<init>", NOTHING_TO_VOID, false);
    code.visitInsn(Opcodes.RETURN);
    code.visitMaxs(0, 0);
    code.visitEnd();
  }

  private void texts(ClassWriter file) {
    MethodVisitor code =
        file.visitMethod(
            Opcodes.ACC_PRIVATE | Opcodes.ACC_STATIC, "texts", "()" + TEXTS, null, null);
    code.visitCode();
    List<String> texts = model.texts();
    code.visitLdcInsn(texts.size());
    code.visitTypeInsn(Opcodes.ANEWARRAY, TEXT);
    for (int i = 0; i < texts.size(); i++) {
      code.visitInsn(Opcodes.DUP);
      code.visitLdcInsn(i);
      code.visitLdcInsn(texts.get(i));
      code.visitInsn(Opcodes.AASTORE);
    }
    end(code);
  }

  /** Writes a method that hands everything over to the method of {@link CompactModel}. */
  private static void method(
      ClassWriter file, String className, String method, String own, String called) {
    MethodVisitor code = file.visitMethod(Opcodes.ACC_PUBLIC, method, own, null, null);
    code.visitCode();
    if (called.contains(LOADER)) {
      code.visitLdcInsn(Type.getObjectType(className));
      code.visitMethodInsn(
          Opcodes.INVOKEVIRTUAL, "java/lang/Class", "getClassLoader", "()" + LOADER, false);
    }
    if (own.startsWith("([D")) {
      code.visitVarInsn(Opcodes.ALOAD, 1);
    }
    code.visitMethodInsn(Opcodes.INVOKESTATIC, className, "texts", "()" + TEXTS, false);
    code.visitMethodInsn(
        Opcodes.INVOKESTATIC, Type.getInternalName(CompactModel.class), method, called, false);
    end(code);
  }

  private static void end(MethodVisitor code) {
    code.visitInsn(Opcodes.ARETURN);
    code.visitMaxs(0, 0);
    code.visitEnd();
  }
}
