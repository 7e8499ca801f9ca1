package org.mechservice.cli;

import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAPackage;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAnyPackage;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideOutsideOfPackage;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;

import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Who may know whom: one direction through the modules, one through the solver's packages. */
class ArchitectureTest {
  private static final String ROOT = "org.mechservice.";
  private static final String SOLVER = ROOT + "solver.";

  /** Lower first; a package knows only those before it. */
  private static final List<String> SOLVER_LAYERS =
      List.of(
          "pack",
          "linear",
          "spatial",
          "api",
          "expression",
          "mechanism",
          "integration",
          "kinematics",
          "force",
          "dynamics",
          "closure",
          "compact",
          "analysis",
          "simulation",
          "standalone");

  private static final JavaClasses PRODUCT =
      new ClassFileImporter()
          .withImportOption(ImportOption.Predefined.DO_NOT_INCLUDE_TESTS)
          .importPackages("org.mechservice");

  @CsvSource({
    "solver, solver",
    "mechml, mechml solver",
    "idl, idl",
    "orb, orb idl",
    "sim, sim mechml solver idl orb",
    "server, server sim idl orb",
    "client, client solver idl orb",
    "admin, admin idl orb",
    "report, report client solver"
  })
  @ParameterizedTest
  void moduleKnowsOnlyTheModulesTheDesignAllows(String module, String allowed) {
    String[] known =
        Stream.of(allowed.split(" ", -1)).map(name -> ROOT + name + "..").toArray(String[]::new);
    classes()
        .that()
        .resideInAPackage(ROOT + module + "..")
        .should()
        .onlyDependOnClassesThat(
            resideOutsideOfPackage("org.mechservice..").or(resideInAnyPackage(known)))
        .check(PRODUCT);
  }

  @ValueSource(
      strings = {
        "pack",
        "linear",
        "spatial",
        "api",
        "expression",
        "mechanism",
        "integration",
        "kinematics",
        "force",
        "dynamics",
        "closure",
        "compact",
        "analysis",
        "simulation"
      })
  @ParameterizedTest
  void solverPackageKnowsNoneAboveIt(String name) {
    String[] above =
        SOLVER_LAYERS.subList(SOLVER_LAYERS.indexOf(name) + 1, SOLVER_LAYERS.size()).stream()
            .map(layer -> SOLVER + layer + "..")
            .toArray(String[]::new);
    noClasses()
        .that()
        .resideInAPackage(SOLVER + name + "..")
        .should()
        .dependOnClassesThat()
        .resideInAnyPackage(above)
        .allowEmptyShould(true)
        .check(PRODUCT);
  }

  @Test
  void everySolverPackageHasItsPlaceInTheLayers() {
    String[] layers =
        SOLVER_LAYERS.stream().map(layer -> SOLVER + layer + "..").toArray(String[]::new);
    classes()
        .that()
        .resideInAPackage(SOLVER + ".")
        .should()
        .resideInAnyPackage(layers)
        .check(PRODUCT);
  }

  @Test
  void integrationKnowsNoMechanics() {
    classes()
        .that()
        .resideInAPackage(SOLVER + "integration..")
        .should()
        .onlyDependOnClassesThat(
            resideOutsideOfPackage("org.mechservice..")
                .or(resideInAnyPackage(SOLVER + "integration..", SOLVER + "linear..")))
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
