package org.mechservice.cli;

import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAPackage;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAnyPackage;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideOutsideOfPackage;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;
import static java.util.Map.entry;
import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Which module may depend on which, and within the solver which package on which. */
@Tag("slow")
class ArchitectureTest {
  private static final String ROOT = "org.mechservice.";
  private static final String SOLVER = ROOT + "solver.";

  /** The packages of each artifact. */
  private static final Map<String, List<String>> PACKAGES =
      Map.ofEntries(
          entry("solver-api", List.of("solver.api", "solver.catalogue", "solver.text")),
          entry("solver-ode", List.of("solver.linear", "solver.ode")),
          entry("solver-symbol", List.of("solver.spatial", "solver.symbol", "solver.expression")),
          entry(
              "solver-mechanics",
              List.of(
                  "solver.mechanism",
                  "solver.kinematics",
                  "solver.distance",
                  "solver.links",
                  "solver.step",
                  "solver.force",
                  "solver.dynamics",
                  "solver.closure")),
          entry(
              "solver-runtime",
              List.of(
                  "solver.compact",
                  "solver.analysis",
                  "solver.simulation",
                  "solver.standalone",
                  "solver.system")),
          entry("mechguard", List.of("guard")),
          entry("mechml", List.of("mechml")),
          entry("mechrobot", List.of("robot")),
          entry("idl", List.of("idl", "orb")),
          entry(
              "mechsim-codegen",
              List.of(
                  "sim.scene",
                  "sim.gradient",
                  "sim.equations",
                  "sim.emit",
                  "sim.fmu",
                  "sim.packaging",
                  "sim.check",
                  "sim.compile",
                  "sim.user",
                  "sim.model")),
          entry("mechsim-service", List.of("sim.service", "sim.host")),
          entry("mechserver", List.of("server")),
          entry("mechclient", List.of("client")),
          entry("mechadmin", List.of("admin")),
          entry("mechreport", List.of("report")),
          entry("mechresult", List.of("result")),
          entry("mechservice", List.of("library")),
          entry("mechstudy", List.of("study")),
          entry("mechstudy-spark", List.of("spark")),
          entry("mechview", List.of("view")),
          entry("mechcli", List.of("cli")));

  /** Stubs that the IDL compiler has written. */
  private static final DescribedPredicate<JavaClass> GENERATED = resideInAPackage(ROOT + "idl..");

  static final JavaClasses PRODUCT =
      new ClassFileImporter()
          .withImportOption(ImportOption.Predefined.DO_NOT_INCLUDE_TESTS)
          .withImportOption(location -> !location.contains("-tests.jar"))
          .importPackages("org.mechservice");

  /** From the top; what an artifact needs of its own dependencies it names again. */
  @CsvSource({
    "solver-api, ''",
    "solver-ode, ''",
    "solver-symbol, ''",
    "solver-mechanics, solver-api solver-ode solver-symbol",
    "solver-runtime, solver-api solver-ode solver-symbol solver-mechanics",
    "mechguard, solver-runtime solver-api solver-ode solver-symbol solver-mechanics",
    "mechml, solver-api solver-ode solver-symbol solver-mechanics",
    "mechrobot, mechml solver-api solver-ode solver-symbol solver-mechanics",
    "idl, solver-api",
    "mechsim-codegen, mechguard mechml solver-runtime solver-api solver-ode solver-symbol solver-mechanics",
    "mechsim-service,"
        + " mechsim-codegen mechguard idl mechrobot mechml solver-runtime solver-api solver-ode"
        + " solver-symbol solver-mechanics",
    "mechserver, mechsim-service idl solver-api",
    "mechclient, mechguard idl mechreport solver-api solver-runtime",
    "mechadmin, idl solver-api",
    "mechreport, solver-runtime solver-api solver-ode",
    "mechresult, solver-api",
    "mechservice, mechsim-codegen mechguard mechreport mechrobot mechml solver-runtime solver-api"
        + " solver-ode solver-symbol solver-mechanics",
    "mechstudy, mechservice mechguard mechresult mechsim-codegen mechml solver-runtime solver-api"
        + " solver-ode solver-symbol solver-mechanics",
    "mechstudy-spark, mechstudy mechguard mechml solver-api",
    "mechview, mechclient mechresult mechservice mechsim-codegen mechml solver-runtime idl"
        + " solver-api solver-ode solver-symbol solver-mechanics",
  })
  @ParameterizedTest
  void moduleDependsOnlyOnTheModulesTheDesignAllows(String module, String allowed) {
    String[] known =
        Stream.concat(Stream.of(module), Stream.of(allowed.split(" ", -1)))
            .filter(name -> !name.isEmpty())
            .flatMap(name -> packagesOf(name).stream())
            .toArray(String[]::new);
    classes()
        .that()
        .resideInAnyPackage(packagesOf(module).toArray(String[]::new))
        .should()
        .onlyDependOnClassesThat(
            resideOutsideOfPackage("org.mechservice..").or(resideInAnyPackage(known)))
        .check(PRODUCT);
  }

  @Test
  void mechanicsNeedsOnlyTheLinearAlgebraOfTheIntegrators() {
    noClasses()
        .that()
        .resideInAnyPackage(packagesOf("solver-mechanics").toArray(String[]::new))
        .should()
        .dependOnClassesThat()
        .resideInAPackage(SOLVER + "ode..")
        .check(PRODUCT);
  }

  @Test
  void everyPackageBelongsToOneModule() {
    String[] all =
        PACKAGES.keySet().stream()
            .flatMap(module -> packagesOf(module).stream())
            .toArray(String[]::new);
    classes().should().resideInAnyPackage(all).check(PRODUCT);
  }

  /** Types of one package may need each other; across packages that is a circle of files. */
  @Test
  void noCircleOfTypesCrossesPackages() {
    Map<JavaClass, Set<JavaClass>> needs = new LinkedHashMap<>();
    PRODUCT.stream()
        .filter(GENERATED.negate())
        .filter(type -> !type.getSimpleName().equals("package-info"))
        .forEach(
            type ->
                type.getDirectDependenciesFromSelf().stream()
                    .map(dependency -> topLevel(dependency.getTargetClass()))
                    .filter(PRODUCT::contains)
                    .forEach(
                        target ->
                            needs
                                .computeIfAbsent(topLevel(type), t -> new LinkedHashSet<>())
                                .add(target)));
    Map<JavaClass, Set<JavaClass>> reached = new LinkedHashMap<>();
    needs.keySet().forEach(type -> reached.put(type, reachedFrom(type, needs)));

    List<String> circles =
        reached.entrySet().stream()
            .flatMap(
                from ->
                    from.getValue().stream()
                        .filter(to -> !to.getPackageName().equals(from.getKey().getPackageName()))
                        .filter(to -> reached.getOrDefault(to, Set.of()).contains(from.getKey()))
                        .map(to -> from.getKey().getName() + " and " + to.getName()))
            .toList();

    assertThat(circles).isEmpty();
  }

  private static JavaClass topLevel(JavaClass type) {
    return type.getBaseComponentType()
        .getEnclosingClass()
        .map(ArchitectureTest::topLevel)
        .orElseGet(type::getBaseComponentType);
  }

  private static Set<JavaClass> reachedFrom(JavaClass type, Map<JavaClass, Set<JavaClass>> needs) {
    Set<JavaClass> reached = new HashSet<>();
    Deque<JavaClass> open = new ArrayDeque<>(needs.getOrDefault(type, Set.of()));
    while (!open.isEmpty()) {
      JavaClass next = open.pop();
      if (reached.add(next)) {
        open.addAll(needs.getOrDefault(next, Set.of()));
      }
    }
    return reached;
  }

  @Test
  void packagesFormNoCircle() {
    slices()
        .matching(ROOT + "(**)")
        .should()
        .beFreeOfCycles()
        .ignoreDependency(GENERATED, DescribedPredicate.alwaysTrue())
        .check(PRODUCT);
  }

  @Test
  void solverNeedsTheBaseModuleOfJavaAlone() {
    classes()
        .that()
        .resideInAPackage(SOLVER + ".")
        .should()
        .onlyDependOnClassesThat(resideInAPackage(SOLVER + ".").or(BaseModule.ONLY))
        .check(PRODUCT);
  }

  /** Returns the module of a package, whose name is relative to the root package. */
  static String moduleOf(String name) {
    return PACKAGES.entrySet().stream()
        .filter(
            module ->
                module.getValue().stream()
                    .anyMatch(prefix -> name.equals(prefix) || name.startsWith(prefix + ".")))
        .map(Map.Entry::getKey)
        .findFirst()
        .orElse("");
  }

  private static List<String> packagesOf(String module) {
    return Objects.requireNonNull(PACKAGES.get(module), module).stream()
        .map(name -> ROOT + name + "..")
        .toList();
  }

  /** Classes of module java.base. */
  private static final class BaseModule extends DescribedPredicate<JavaClass> {
    static final BaseModule ONLY = new BaseModule();

    private BaseModule() {
      super("are in module java.base");
    }

    @Override
    public boolean test(JavaClass type) {
      JavaClass element = type.getBaseComponentType();
      if (element.isPrimitive()) {
        return true;
      }
      return ModuleLayer.boot()
          .findModule("java.base")
          .map(module -> module.getPackages().contains(element.getPackageName()))
          .orElse(false);
    }
  }
}
