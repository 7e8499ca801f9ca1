package org.mechservice.sim.emit;

import java.util.function.Consumer;
import org.mechservice.sim.emit.bytes.ClassMethods;
import org.mechservice.solver.api.ModelSource;
import org.mechservice.solver.api.Solver;
import org.mechservice.solver.ode.Integrator;
import org.mechservice.solver.ode.IntegratorFactory;
import org.mechservice.solver.ode.IntegratorSettings;
import org.mechservice.solver.ode.jumps.UndeclaredJumps;
import org.mechservice.solver.ode.step.WatchedIntegrator;
import org.mechservice.solver.simulation.AnalysisSolver;
import org.mechservice.solver.simulation.Simulation;
import org.mechservice.solver.simulation.equations.EquationForm;
import org.mechservice.solver.simulation.equations.WatchedForm;
import org.mechservice.solver.standalone.Standalone;
import org.objectweb.asm.ClassWriter;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.Type;

/**
 * The main class of a standalone JAR:
 *
 * <pre>{@code
 * public final class PendulumMain implements IntegratorFactory {
 *   public Integrator create(IntegratorSettings settings) {
 *     return new De(settings);
 *   }
 *
 *   public static void main(String[] args) {
 *     System.exit(
 *         Standalone.run(
 *             ModelSource.from(new Pendulum()),
 *             new Simulation(new PendulumMain(), new ExplicitForm()),
 *             "joints,accelerations,energy",
 *             "joints",
 *             args));
 *   }
 * }
 * }</pre>
 *
 * <p>The class itself implements the factory, which avoids a lambda. For a model with forces by
 * classes of users it returns {@code UndeclaredJumps.around(new De(settings))}; only then does the
 * JAR have these classes. For an analysis without integration the solver is an {@link
 * AnalysisSolver}, and there is no factory.
 */
public final class MainClass {
  private static final String OBJECT = "java/lang/Object";
  private static final String NOTHING_TO_VOID = "()V";

  private final ClassWriter classFile = new ClassWriter(ClassWriter.COMPUTE_MAXS);

  private MainClass() {}

  /**
   * Returns the class file of a model that is integrated.
   *
   * @param className its own fully qualified name
   * @param model fully qualified name of the class of the model
   * @param integrator fully qualified name of the class of the integrator
   * @param userClasses whether classes of users compute some of its forces
   * @param form form of the equations for the integrator
   * @param built labels of the column groups of the model, separated by commas
   * @param shown labels of the groups of the default output
   */
  public static byte[] of(
      String className,
      String model,
      String integrator,
      boolean userClasses,
      EquationForm form,
      String built,
      String shown) {
    MainClass main = new MainClass();
    String own = internal(className);
    main.begin(own, Type.getInternalName(IntegratorFactory.class));
    main.create(internal(integrator), userClasses);
    main.main(internal(model), code -> simulation(code, own, form), built, shown);
    main.classFile.visitEnd();
    return main.classFile.toByteArray();
  }

  /** Returns the class file of a model that is not integrated; arguments as for {@link #of}. */
  public static byte[] ofAnalysis(String className, String model, String built, String shown) {
    MainClass main = new MainClass();
    main.begin(internal(className));
    main.main(
        internal(model),
        code -> create(code, Type.getInternalName(AnalysisSolver.class)),
        built,
        shown);
    main.classFile.visitEnd();
    return main.classFile.toByteArray();
  }

  private static String internal(String className) {
    return className.replace('.', '/');
  }

  private void begin(String className, String... interfaces) {
    classFile.visit(
        Opcodes.V17,
        Opcodes.ACC_PUBLIC | Opcodes.ACC_FINAL | Opcodes.ACC_SUPER,
        className,
        null,
        OBJECT,
        interfaces);
    constructor();
  }

  /** {@code new Simulation(new PendulumMain(), new ExplicitForm())}. */
  private static void simulation(MethodVisitor code, String factory, EquationForm form) {
    String simulation = Type.getInternalName(Simulation.class);
    code.visitTypeInsn(Opcodes.NEW, simulation);
    code.visitInsn(Opcodes.DUP);
    create(code, factory);
    create(code, form);
    code.visitMethodInsn(
        Opcodes.INVOKESPECIAL,
        simulation,
        "<init>",
        "("
            + Type.getDescriptor(IntegratorFactory.class)
            + Type.getDescriptor(EquationForm.class)
            + ")V",
        false);
  }

  private void constructor() {
    MethodVisitor code =
        ClassMethods.begin(classFile, Opcodes.ACC_PUBLIC, "<init>", NOTHING_TO_VOID);
    code.visitVarInsn(Opcodes.ALOAD, 0);
    code.visitMethodInsn(Opcodes.INVOKESPECIAL, OBJECT, "<init>", NOTHING_TO_VOID, false);
    ClassMethods.end(code, Opcodes.RETURN);
  }

  private void create(String integrator, boolean userClasses) {
    String settings = Type.getDescriptor(IntegratorSettings.class);
    MethodVisitor code =
        ClassMethods.begin(
            classFile,
            Opcodes.ACC_PUBLIC,
            "create",
            "(" + settings + ")" + Type.getDescriptor(Integrator.class));
    code.visitTypeInsn(Opcodes.NEW, integrator);
    code.visitInsn(Opcodes.DUP);
    code.visitVarInsn(Opcodes.ALOAD, 1);
    code.visitMethodInsn(Opcodes.INVOKESPECIAL, integrator, "<init>", "(" + settings + ")V", false);
    if (userClasses) {
      String watched = Type.getDescriptor(WatchedIntegrator.class);
      code.visitMethodInsn(
          Opcodes.INVOKESTATIC,
          Type.getInternalName(UndeclaredJumps.class),
          "around",
          "(" + watched + ")" + watched,
          false);
    }
    ClassMethods.end(code, Opcodes.ARETURN);
  }

  private void main(String model, Consumer<MethodVisitor> solver, String built, String shown) {
    String strings = "[Ljava/lang/String;";
    MethodVisitor code =
        ClassMethods.begin(
            classFile, Opcodes.ACC_PUBLIC | Opcodes.ACC_STATIC, "main", "(" + strings + ")V");
    create(code, model);
    code.visitMethodInsn(
        Opcodes.INVOKESTATIC,
        Type.getInternalName(ModelSource.class),
        "from",
        "(L" + OBJECT + ";)" + Type.getDescriptor(ModelSource.class),
        true);
    solver.accept(code);
    code.visitLdcInsn(built);
    code.visitLdcInsn(shown);
    code.visitVarInsn(Opcodes.ALOAD, 0);
    code.visitMethodInsn(
        Opcodes.INVOKESTATIC,
        Type.getInternalName(Standalone.class),
        "run",
        "("
            + Type.getDescriptor(ModelSource.class)
            + Type.getDescriptor(Solver.class)
            + "Ljava/lang/String;".repeat(2)
            + strings
            + ")I",
        false);
    code.visitMethodInsn(Opcodes.INVOKESTATIC, "java/lang/System", "exit", "(I)V", false);
    ClassMethods.end(code, Opcodes.RETURN);
  }

  /** Pushes a form; a form that monitors a run contains another form. */
  private static void create(MethodVisitor code, EquationForm form) {
    if (form instanceof WatchedForm watched) {
      String around = Type.getInternalName(WatchedForm.class);
      code.visitTypeInsn(Opcodes.NEW, around);
      code.visitInsn(Opcodes.DUP);
      create(code, watched.equations());
      String constructor = "(" + Type.getDescriptor(EquationForm.class) + ")V";
      code.visitMethodInsn(Opcodes.INVOKESPECIAL, around, "<init>", constructor, false);
    } else {
      create(code, Type.getInternalName(form.getClass()));
    }
  }

  private static void create(MethodVisitor code, String className) {
    code.visitTypeInsn(Opcodes.NEW, className);
    code.visitInsn(Opcodes.DUP);
    code.visitMethodInsn(Opcodes.INVOKESPECIAL, className, "<init>", NOTHING_TO_VOID, false);
  }
}
