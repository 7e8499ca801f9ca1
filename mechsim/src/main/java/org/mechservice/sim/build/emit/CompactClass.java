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

  @Override
  public String simpleName() {
    return JavaText.className(model.mechanism().name());
  }

  @Override
  public String source() {
    SourceLines source = new SourceLines();
    source.line("package " + ModelClass.PACKAGE + ";").blank();
    source.line("import org.mechservice.solver.api.Model;");
    source.line("import org.mechservice.solver.api.ModelSource;");
    source.line("import org.mechservice.solver.compact.CompactModel;").blank();
    source.documentation(
        List.of(
            JavaText.comment("Model \"" + model.mechanism().name() + "\" in compact form: data.")));
    source.open("public final class " + simpleName() + " implements ModelSource");
    source.line("@Override").open("public Model model()");
    source.line("return CompactModel.model(");
    source.line("    " + simpleName() + ".class.getClassLoader(),");
    List<String> texts = model.texts();
    for (int i = 0; i < texts.size(); i++) {
      source.line("    " + literal(texts.get(i)) + (i + 1 < texts.size() ? "," : ");"));
    }
    source.close();
    return source.close().toString();
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
    model(file, name);
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

  private void model(ClassWriter file, String name) {
    String toModel = "()" + Type.getDescriptor(Model.class);
    MethodVisitor code = file.visitMethod(Opcodes.ACC_PUBLIC, "model", toModel, null, null);
    code.visitCode();
    code.visitLdcInsn(Type.getObjectType(name));
    code.visitMethodInsn(
        Opcodes.INVOKEVIRTUAL,
        "java/lang/Class",
        "getClassLoader",
        "()Ljava/lang/ClassLoader;",
        false);
    List<String> texts = model.texts();
    code.visitLdcInsn(texts.size());
    code.visitTypeInsn(Opcodes.ANEWARRAY, TEXT);
    for (int i = 0; i < texts.size(); i++) {
      code.visitInsn(Opcodes.DUP);
      code.visitLdcInsn(i);
      code.visitLdcInsn(texts.get(i));
      code.visitInsn(Opcodes.AASTORE);
    }
    code.visitMethodInsn(
        Opcodes.INVOKESTATIC,
        Type.getInternalName(CompactModel.class),
        "model",
        "(Ljava/lang/ClassLoader;[Ljava/lang/String;)" + Type.getDescriptor(Model.class),
        false);
    code.visitInsn(Opcodes.ARETURN);
    code.visitMaxs(0, 0);
    code.visitEnd();
  }
}
