package org.mechservice.sim.build.emit;

import java.util.List;
import org.mechservice.solver.analysis.FurtherColumns;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.ModelSource;
import org.mechservice.solver.compact.CompactModel;
import org.objectweb.asm.ClassWriter;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.Type;

/**
 * A model's class in compact form: it holds the mechanism as data, and the solver's data-driven
 * formulations compute with them; or the further columns of a model alone, of which code was
 * generated.
 *
 * @param model what it holds
 * @param columns groups of columns computed from the data, beside the model, separated by commas;
 *     empty for none
 * @param generated simple name of the generated class that is extended by columns; empty if the
 *     model itself is data
 */
public record CompactClass(CompactModel model, String columns, String generated)
    implements WrittenClass {
  private static final String LOADER = "Ljava/lang/ClassLoader;";
  private static final String TEXTS = "[Ljava/lang/String;";

  private static final String OBJECT = "java/lang/Object";
  private static final String NOTHING_TO_VOID = "()V";
  private static final String TEXT = "java/lang/String";

  @Override
  public String simpleName() {
    String name = JavaText.className(model.mechanism().name());
    return generated.isEmpty() ? name : name + "WithColumns";
  }

  @Override
  public String source() {
    SourceLines source = new SourceLines();
    source.line("package " + ModelClass.PACKAGE + ";").blank();
    if (!columns.isEmpty()) {
      source.line("import org.mechservice.solver.analysis.FurtherColumns;");
    }
    source.line("import org.mechservice.solver.api.Model;");
    source.line("import org.mechservice.solver.api.ModelSource;");
    if (generated.isEmpty()) {
      source.line("import org.mechservice.solver.compact.CompactModel;");
    }
    source.blank();
    source.documentation(
        List.of(
            JavaText.comment("Model \"" + model.mechanism().name() + "\" in compact form: data.")));
    source.open("public final class " + simpleName() + " implements ModelSource");
    source.line("@Override").open("public Model model()");
    source.line("ClassLoader loader = " + simpleName() + ".class.getClassLoader();");
    source.line("String[] data = {");
    List<String> texts = model.texts();
    for (int i = 0; i < texts.size(); i++) {
      source.line("  " + literal(texts.get(i)) + (i + 1 < texts.size() ? "," : ""));
    }
    source.line("};");
    String bare =
        generated.isEmpty() ? "CompactModel.model(loader, data)" : "new " + generated + "()";
    source.line(
        "return "
            + (columns.isEmpty()
                ? bare
                : "FurtherColumns.extend(" + bare + ", loader, \"" + columns + "\", data)")
            + ";");
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
        Opcodes.INVOKEVIRTUAL, "java/lang/Class", "getClassLoader", "()" + LOADER, false);
    code.visitVarInsn(Opcodes.ASTORE, 1);
    List<String> texts = model.texts();
    code.visitLdcInsn(texts.size());
    code.visitTypeInsn(Opcodes.ANEWARRAY, TEXT);
    for (int i = 0; i < texts.size(); i++) {
      code.visitInsn(Opcodes.DUP);
      code.visitLdcInsn(i);
      code.visitLdcInsn(texts.get(i));
      code.visitInsn(Opcodes.AASTORE);
    }
    code.visitVarInsn(Opcodes.ASTORE, 2);
    bare(code);
    if (!columns.isEmpty()) {
      code.visitVarInsn(Opcodes.ALOAD, 1);
      code.visitLdcInsn(columns);
      code.visitVarInsn(Opcodes.ALOAD, 2);
      String arguments = "(L" + OBJECT + ";" + LOADER + "L" + TEXT + ";" + TEXTS + ")";
      toModel(code, FurtherColumns.class, "extend", arguments);
    }
    code.visitInsn(Opcodes.ARETURN);
    code.visitMaxs(0, 0);
    code.visitEnd();
  }

  /** Pushes the model without further columns. */
  private void bare(MethodVisitor code) {
    if (generated.isEmpty()) {
      code.visitVarInsn(Opcodes.ALOAD, 1);
      code.visitVarInsn(Opcodes.ALOAD, 2);
      toModel(code, CompactModel.class, "model", "(" + LOADER + TEXTS + ")");
      return;
    }
    String own = (ModelClass.PACKAGE + "." + generated).replace('.', '/');
    code.visitTypeInsn(Opcodes.NEW, own);
    code.visitInsn(Opcodes.DUP);
    code.visitMethodInsn(Opcodes.INVOKESPECIAL, own, "<init>", NOTHING_TO_VOID, false);
  }

  private static void toModel(MethodVisitor code, Class<?> owner, String name, String arguments) {
    code.visitMethodInsn(
        Opcodes.INVOKESTATIC,
        Type.getInternalName(owner),
        name,
        arguments + Type.getDescriptor(Model.class),
        false);
  }
}
