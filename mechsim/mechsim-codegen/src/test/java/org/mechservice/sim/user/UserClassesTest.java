package org.mechservice.sim.user;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.concurrent.CancellationException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.guard.UserCode;
import org.mechservice.mechml.diagnosis.Diagnostic;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.solver.api.UserForce;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.compact.LoadedUserForces;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.force.UserForceElement;

/** What classes of users have to be before they are let in. */
class UserClassesTest {
  private static final Mechanism CART = cart();

  private static Mechanism cart() {
    try {
      return MechmlReader.read("pushed.xml", PushedCart.file()).mechanism();
    } catch (MechmlException e) {
      throw new AssertionError(e);
    }
  }

  private static List<Diagnostic> refused(UserFile... files) {
    return catchThrowableOfType(
            MechmlException.class, () -> UserClasses.admit(CART, List.of(files), true))
        .diagnostics();
  }

  private static String only(List<Diagnostic> said) {
    assertThat(said).hasSize(1);
    return said.get(0).toString();
  }

  @Test
  void sourceBecomesAClassThatImplementsTheForce() throws Exception {
    UserClasses classes =
        UserClasses.admit(CART, List.of(PushedCart.asSource(PushedCart.source())), true);
    assertThat(
            UserClasses.loaderOf(classes.classFiles())
                .loadClass("car.Push")
                .getConstructor()
                .newInstance())
        .isInstanceOf(UserForce.class);
  }

  @Test
  void admittingLoadsNothing() throws Exception {
    System.clearProperty(PushedCart.TRACE);
    UserClasses classes =
        UserClasses.admit(CART, List.of(PushedCart.asSource(PushedCart.source())), true);
    assertThat(System.getProperty(PushedCart.TRACE)).isNull();
    UserClasses.loaderOf(classes.classFiles()).loadClass("car.Push").getConstructor().newInstance();
    assertThat(System.clearProperty(PushedCart.TRACE)).isEqualTo("yes");
  }

  @Test
  void loadedClassSeesTheForceInterfaceAndNothingElseOfTheProcess() throws Exception {
    UserClasses classes =
        UserClasses.admit(CART, List.of(PushedCart.asSource(PushedCart.source())), true);
    assertThat(
            catchThrowableOfType(
                ClassNotFoundException.class,
                () ->
                    UserClasses.loaderOf(classes.classFiles())
                        .loadClass("org.mechservice.solver.mechanism.Mechanism")))
        .isNotNull();
  }

  /** Two kilobytes that stand for a text of half a terabyte, which the compiler folds. */
  private static String folded(String use) {
    StringBuilder constants =
        new StringBuilder("static final String a0 = \"" + "x".repeat(60) + "\";");
    for (int i = 1; i < 34; i++) {
      constants.append("static final String a%d = a%d + a%d;\n".formatted(i, i - 1, i - 1));
    }
    return PushedCart.harmlessSource().replaceFirst("\\{", "{ " + constants + use);
  }

  @Test
  void sourceThatTakesTheMemoryOfTheCompilerTakesNothingOfThisProcess() throws Exception {
    Runtime here = Runtime.getRuntime();
    long before = here.totalMemory() - here.freeMemory();
    String refusal = only(refused(PushedCart.asSource(folded("int n = a33.length();"))));
    assertThat(refusal).contains("S-123", "the compiler gives up", "MB of memory");
    assertThat(here.totalMemory() - here.freeMemory() - before).isLessThan(200L << 20);
    assertThat(
            UserClasses.admit(CART, List.of(PushedCart.asSource(PushedCart.harmlessSource())), true)
                .classFiles())
        .isNotEmpty();
  }

  /** As the end of a session interrupts its calls. */
  @Test
  void compilerEndsWithItsCaller() throws Exception {
    long before = compilers();
    Thread caller =
        new Thread(
            () -> {
              try {
                UserClasses.admit(
                    CART, List.of(PushedCart.asSource(folded("int n = a33.length();"))), true);
              } catch (MechmlException | CancellationException e) {
                // What was asked for.
              }
            });
    caller.start();
    Thread.sleep(300);
    caller.interrupt();
    caller.join(20_000);
    assertThat(caller.isAlive()).isFalse();
    long end = System.nanoTime() + 20_000_000_000L;
    while (compilers() > before + 1 && System.nanoTime() < end) {
      Thread.sleep(50);
    }
    assertThat(compilers()).isLessThanOrEqualTo(before + 1);
  }

  /** Processes of compilers; one may wait for the next source. */
  private static long compilers() {
    return ProcessHandle.current()
        .descendants()
        .filter(process -> process.info().commandLine().orElse("").contains("CompilerMain"))
        .count();
  }

  /** No path of the program leads to a class of a user in its own process. */
  @Test
  void admittedClassesRunInNoProcessBeforeTheyAreLetIn() throws Exception {
    UserClasses classes =
        UserClasses.admit(CART, List.of(PushedCart.asSource(PushedCart.source())), true);
    assertThatThrownBy(classes::loader).isInstanceOf(IllegalStateException.class);
    assertThatThrownBy(() -> classes.forThisProcess(UserCode.NONE))
        .isInstanceOf(MechmlException.class)
        .hasMessageContaining("S-156");
  }

  /** Reflection writes a class of its own for a constructor that is called often. */
  @Test
  void forceIsMadeAsOftenAsRunsNeedIt() throws Exception {
    UserClasses classes =
        UserClasses.admit(CART, List.of(PushedCart.asSource(PushedCart.source())), true);
    LoadedUserForces forces = new LoadedUserForces(UserClasses.loaderOf(classes.classFiles()));
    UserForceElement push =
        CART.forces().stream()
            .filter(UserForceElement.class::isInstance)
            .map(UserForceElement.class::cast)
            .findFirst()
            .orElseThrow();
    for (int i = 0; i < 40; i++) {
      assertThat(forces.create(push).getClass().getName()).isEqualTo("car.Push");
    }
    System.clearProperty(PushedCart.TRACE);
  }

  @Test
  void missingClassIsNamedByItsFile() {
    Diagnostic said = refused().get(0);
    assertThat(said.code()).isEqualTo(MessageCode.USER_CLASS_MISSING);
    assertThat(said.file()).isEqualTo("car/Push.class");
    assertThat(said.message()).startsWith("force \"push\" (pushed.xml:");
  }

  @Test
  void classThatASourceUsesIsAskedForToo() {
    String text = PushedCart.source().replace("(slide, 3)", "(slide, Strength.of())");
    assertThat(refused(PushedCart.asSource(text)).get(0).file()).isEqualTo("car/Strength.class");
  }

  @Test
  void classThatAClassFileUsesIsAskedForToo() {
    String text =
        PushedCart.source()
            .replace("(slide, 3)", "(slide, Strength.of())")
            .replace(
                "public class", "class Strength { static int of() { return 3; } } public class");
    assertThat(refused(PushedCart.compiled("Push", text, "17")).get(0).file())
        .isEqualTo("car/Strength.class");
  }

  @Test
  void compilersWordIsGivenWithItsPlace() {
    String text = PushedCart.source().replace("loads.addJointForce", "loads.pushWith");
    assertThat(only(refused(PushedCart.asSource(text))))
        .startsWith("car/Push.java:20:10: S-123 cannot find symbol; symbol:   method pushWith");
  }

  @Test
  void sourceSeesNoMoreOfTheProductThanTheInterface() {
    String text =
        PushedCart.source()
            .replace("package car;", "package car; import org.mechservice.solver.linear.*;");
    assertThat(only(refused(PushedCart.asSource(text))))
        .contains("S-123 package org.mechservice.solver.linear does not exist");
  }

  @Test
  void sourceSeesNoModuleOfJavaButItsBase() {
    String text = PushedCart.source().replace("package car;", "package car; import java.sql.*;");
    assertThat(only(refused(PushedCart.asSource(text)))).contains("S-123", "java.sql");
  }

  @CsvSource(
      delimiter = '|',
      value = {
        "implements UserForce | implements Runnable | does not implement",
        "public class | class | is not public",
        "public class | public abstract class | is abstract",
        "private int slide; | private int slide; Push(int x) {} | has no public constructor",
      })
  @ParameterizedTest
  void classThatCannotBeTheForceSaysWhy(String from, String to, String why) {
    String text = PushedCart.source().replace(from, to);
    String complete =
        to.contains("Runnable")
            ? text.replace("private int", "public void run() {} private int")
            : text;
    assertThat(only(refused(PushedCart.asSource(complete))))
        .startsWith("car.Push: S-068 force \"push\" (pushed.xml:")
        .contains(why);
  }

  @Test
  void otherPackageInsideTheFileIsRefused() {
    String text = PushedCart.source().replace("package car;", "package bus;");
    assertThat(only(refused(PushedCart.asSource(text))))
        .contains("S-124")
        .contains("what came is bus.Push");
  }

  @Test
  void packagesOfTheProductAreTaken() {
    UserFile intruder =
        new UserFile(
            "X.java",
            "package org.mechservice.solver.api; public class X {}"
                .getBytes(StandardCharsets.UTF_8));
    assertThat(refused(intruder).get(0).message()).contains("in a package of Java or MechService");
  }

  @Test
  void classFileThatReachesBehindTheInterfaceIsRefused() {
    String text =
        PushedCart.source()
            .replace(
                "private int slide;",
                "private int slide; Object o = new org.mechservice.solver.linear.DenseLu(3);");
    assertThat(only(refused(PushedCart.compiled("Push", text, "17"))))
        .contains("S-124")
        .contains("not part of the force interface");
  }

  @Test
  void damagedClassFilesAreRefusedWhateverTheDamage() {
    byte[] good = PushedCart.compiled("Push", PushedCart.source(), "17").content();
    for (int cut = 0; cut < good.length; cut += 7) {
      byte[] bad = java.util.Arrays.copyOf(good, cut);
      assertThat(refused(new UserFile("car/Push.class", bad)).get(0).code())
          .isEqualTo(MessageCode.USER_CLASS_FILE_UNUSABLE);
    }
  }

  @Test
  void classOfANewerJavaIsRefusedWithTheWayOut() {
    byte[] file = PushedCart.compiled("Push", PushedCart.source(), "17").content().clone();
    file[7] = 65;
    assertThat(only(refused(new UserFile("car/Push.class", file))))
        .contains("compiled for Java 21")
        .contains("--release 17");
  }

  @Test
  void fileOfNoKnownKindIsRefused() {
    assertThat(refused(new UserFile("../car/Push.class", new byte[0])).get(0).code())
        .isEqualTo(MessageCode.USER_CLASS_FILE_UNUSABLE);
  }

  @Test
  void sourceThatIsTooMuchForTheCompilerIsRefused() {
    String deep = "(".repeat(100_000) + "3" + ")".repeat(100_000);
    String text = PushedCart.source().replace("(slide, 3)", "(slide, " + deep + ")");
    assertThat(refused(PushedCart.asSource(text)).get(0).code())
        .isEqualTo(MessageCode.USER_SOURCE_DOES_NOT_COMPILE);
  }
}
