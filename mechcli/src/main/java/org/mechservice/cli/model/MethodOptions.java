package org.mechservice.cli.model;

import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.mechservice.cli.shell.UsageException;
import org.mechservice.client.SimulationOptions;
import org.mechservice.mechml.SimulationSettings;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.catalogue.MessageCode;
import picocli.CommandLine.Option;

/** Which simulation of the file runs, by which method, and the columns of its results. */
public final class MethodOptions {
  private static final String ALL = "all";

  @Option(
      names = "--simulation",
      paramLabel = "NAME|N",
      description = "Simulation of the file, by name or number; the first if left out.")
  private String simulation = "";

  @Option(
      names = "--formulation",
      paramLabel = "auto|DTR|DSR|RR|RR-JF",
      hideParamSyntax = true,
      description = "Equations of motion: auto, DTR, DSR, RR or RR-JF (default: the file's).")
  private String formulation = "";

  @Option(
      names = "--integrator",
      paramLabel = "auto|ode113|DE|ode15s|ode15sR|switching",
      hideParamSyntax = true,
      description =
          "Integration method: auto, ode113, DE, ode15s, ode15sR or switching (default: the"
              + " file's).")
  private String integrator = "";

  @Option(
      names = "--closure",
      paramLabel = "auto|projection|penalty",
      hideParamSyntax = true,
      description =
          "How loops are closed: auto, projection or penalty; with numbers of its own"
              + " penalty:alpha=1e7,omega=10,mu=1 (default: the file's).")
  private String closure = "";

  @Option(
      names = "--columns",
      split = ",",
      paramLabel = "GROUPS",
      hideParamSyntax = true,
      description =
          "Columns of the results besides time and joints: joints, accelerations, bodies, energy,"
              + " constraints, reactions, forces, outputs, momentum, drives, separated by commas,"
              + " or all (default: the file's).")
  private List<String> columns = List.of();

  /** Returns the simulation given; empty if none is. */
  Optional<String> simulation() {
    return simulation.isEmpty() ? Optional.empty() : Optional.of(simulation);
  }

  /** Returns the settings of a simulation with those that are given here. */
  SimulationSettings addTo(SimulationSettings settings) {
    SimulationSettings all = settings;
    if (!formulation.isEmpty()) {
      all = all.withFormulation(formulation);
    }
    if (!integrator.isEmpty()) {
      all = all.with(all.run().withIntegrator(integrator));
    }
    return columns.isEmpty()
        ? all
        : all.withColumns(groups().stream().map(ColumnGroup::label).toList());
  }

  /** Returns the closure given; empty if none is. */
  String closure() {
    return closure;
  }

  /** Returns the options given with these added. */
  public SimulationOptions addTo(SimulationOptions options) {
    SimulationOptions all = simulation.isEmpty() ? options : options.simulation(simulation);
    if (!formulation.isEmpty()) {
      all = all.formulation(formulation);
    }
    if (!integrator.isEmpty()) {
      all = all.integrator(integrator);
    }
    if (!closure.isEmpty()) {
      all = all.closure(closure);
    }
    return columns.isEmpty() ? all : all.columns(groups());
  }

  private Set<ColumnGroup> groups() {
    if (columns.contains(ALL)) {
      return EnumSet.allOf(ColumnGroup.class);
    }
    EnumSet<ColumnGroup> groups = EnumSet.noneOf(ColumnGroup.class);
    columns.forEach(name -> groups.add(group(name.strip())));
    return groups;
  }

  private static ColumnGroup group(String name) {
    for (ColumnGroup group : ColumnGroup.values()) {
      if (group.label().equals(name.toLowerCase(Locale.ROOT))) {
        return group;
      }
    }
    throw new UsageException(
        MessageCode.OPTION_UNUSABLE
            + " --columns: \""
            + name
            + "\" is no column group; there are "
            + Stream.of(ColumnGroup.values())
                .map(ColumnGroup::label)
                .collect(Collectors.joining(", "))
            + ", and all");
  }
}
