package org.mechservice.cli.picture;

import com.google.gson.Gson;
import com.google.gson.GsonBuilder;
import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.Callable;
import org.mechservice.cli.shell.ExitStatus;
import org.mechservice.cli.shell.JUnitFile;
import org.mechservice.cli.shell.MechVersion;
import org.mechservice.cli.shell.UsageException;
import org.mechservice.result.ResultComparison;
import org.mechservice.result.SignalDifference;
import org.mechservice.result.SignalTable;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.text.ShortestDecimal;
import org.mechservice.view.plot.DifferencePlot;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code mech compare}: what differs between two results. */
@Command(
    name = "compare",
    description = {
      "Compares two results signal by signal: files that mech simulate writes, in any format.",
      "Two signals are equal if each comes within the time tolerance as near to the other as the"
          + " tolerance allows. Columns that one result lacks, other units and another interval are"
          + " differences too."
    },
    footer = "mech compare before.csv after.csv --tolerance 1e-6",
    mixinStandardHelpOptions = true,
    versionProvider = MechVersion.class,
    exitCodeListHeading = "%nExit status:%n",
    exitCodeList = {"0:equal", "1:different", "2:bad usage or bad input"})
public final class CompareCommand implements Callable<Integer> {
  private static final int DIFFERENT = 1;
  private static final String SAME_COLUMNS = "columns, units and interval are the same";
  private static final Gson JSON =
      new GsonBuilder().setPrettyPrinting().disableHtmlEscaping().create();
  private static final String LINE = "%-24s %-8s %12s %14s %14s %12s %12s%n";

  @Parameters(index = "0", paramLabel = "A", description = "First result.")
  private Path first = Path.of("");

  @Parameters(index = "1", paramLabel = "B", description = "Second result.")
  private Path second = Path.of("");

  @Option(
      names = "--tolerance",
      paramLabel = "R",
      description =
          "Allowed difference relative to the size of a signal, which is the range of its values"
              + " (default: ${DEFAULT-VALUE}).")
  private double tolerance = 1e-3;

  @Option(
      names = "--time-tolerance",
      paramLabel = "T",
      description =
          "Allowed shift in time, s (default: R times the duration), so that a jump may come a"
              + " little earlier.")
  private Optional<Double> timeTolerance = Optional.empty();

  @Option(
      names = "--worst",
      paramLabel = "N",
      description = "Print the N signals that differ most (default: ${DEFAULT-VALUE}).")
  private int worst = 10;

  @Option(names = "--quiet", description = "Print nothing; the exit status tells.")
  private boolean quiet;

  @Option(names = "--json", description = "Print all signals as one JSON object.")
  private boolean json;

  @Option(
      names = "--junit",
      paramLabel = "FILE.xml",
      description = "Write the signals as test cases in the XML of JUnit.")
  private Optional<Path> junit = Optional.empty();

  @Option(
      names = {"-o", "--output", "--out"},
      paramLabel = "FILE.svg|png|html",
      hideParamSyntax = true,
      description =
          "Draw the signals that differ most: both results over each other, and their difference.")
  private Optional<Path> picture = Optional.empty();

  @Mixin private DarkOption theme = new DarkOption();

  @Spec private CommandSpec spec = CommandSpec.create();

  @Override
  public Integer call() throws IOException {
    require(tolerance, "--tolerance");
    timeTolerance.ifPresent(time -> require(time, "--time-tolerance"));
    OptionalDouble shift =
        timeTolerance.isPresent() ? OptionalDouble.of(timeTolerance.get()) : OptionalDouble.empty();
    Optional<String> format = picture.map(PictureFile::formatOfDiagram);
    SignalTable a = SignalTable.read(first);
    SignalTable b = SignalTable.read(second);
    ResultComparison comparison = ResultComparison.of(a, b, tolerance, shift);
    if (picture.isPresent() && format.isPresent()) {
      List<String> names = List.of(first.toString(), second.toString());
      PictureFile.write(
          picture.get(), format.get(), DifferencePlot.of(names, a, b, comparison), theme.isDark());
    }
    if (junit.isPresent()) {
      cases(comparison).write(junit.get());
    }
    PrintWriter out = spec.commandLine().getOut();
    if (json) {
      out.println(JSON.toJson(asJson(comparison)));
    } else if (!quiet) {
      print(comparison, out);
    }
    return comparison.isEqual() ? ExitStatus.DONE : DIFFERENT;
  }

  /** Returns one case for what the results hold, and one for each signal of both. */
  private JUnitFile cases(ResultComparison comparison) {
    JUnitFile cases = new JUnitFile("mech compare " + first + " " + second);
    if (comparison.remarks().isEmpty()) {
      cases.passed(SAME_COLUMNS);
    } else {
      cases.failed(SAME_COLUMNS, String.join("\n", comparison.remarks()));
    }
    for (SignalDifference signal : comparison.signals()) {
      if (comparison.differs(signal)) {
        cases.failed(
            signal.name(),
            "%s is %s and %s %s at %s s: %s of its size apart"
                .formatted(
                    signal.name(),
                    shown(signal.first(), 8),
                    shown(signal.second(), 8),
                    signal.unit(),
                    shown(signal.time(), 6),
                    shown(signal.relative(), 4)));
      } else {
        cases.passed(signal.name());
      }
    }
    return cases;
  }

  private static void require(double value, String option) {
    if (!(value >= 0 && Double.isFinite(value))) {
      throw new UsageException(
          MessageCode.OPTION_UNUSABLE + " " + option + " is " + value + "; it must be 0 or more");
    }
  }

  private void print(ResultComparison comparison, PrintWriter out) {
    comparison.remarks().forEach(out::println);
    List<SignalDifference> signals = comparison.signals();
    long different = signals.stream().filter(comparison::differs).count();
    out.println(
        different
            + " of "
            + signals.size()
            + " signals differ by more than "
            + ShortestDecimal.format(tolerance)
            + " of their size; time tolerance "
            + ShortestDecimal.format(comparison.timeTolerance())
            + " s");
    if (!signals.isEmpty() && signals.get(0).difference() > 0) {
      out.printf(Locale.ROOT, LINE, "signal", "unit", "t", "A", "B", "difference", "of its size");
    }
    signals.stream()
        .filter(signal -> signal.difference() > 0)
        .limit(worst)
        .forEach(
            signal ->
                out.printf(
                    Locale.ROOT,
                    LINE,
                    signal.name(),
                    signal.unit(),
                    shown(signal.time(), 6),
                    shown(signal.first(), 8),
                    shown(signal.second(), 8),
                    shown(signal.difference(), 4),
                    shown(signal.relative(), 4) + (comparison.differs(signal) ? " *" : "")));
  }

  private static String shown(double value, int digits) {
    return String.format(Locale.ROOT, "%." + digits + "g", value);
  }

  private JsonObject asJson(ResultComparison comparison) {
    JsonObject all = new JsonObject();
    all.addProperty("equal", comparison.isEqual());
    all.addProperty("tolerance", tolerance);
    all.addProperty("timeTolerance", comparison.timeTolerance());
    JsonArray remarks = new JsonArray();
    comparison.remarks().forEach(remarks::add);
    all.add("remarks", remarks);
    JsonArray signals = new JsonArray();
    for (SignalDifference signal : comparison.signals()) {
      JsonObject one = new JsonObject();
      one.addProperty("name", signal.name());
      one.addProperty("unit", signal.unit());
      one.addProperty("differs", comparison.differs(signal));
      add(one, "time", signal.time());
      add(one, "first", signal.first());
      add(one, "second", signal.second());
      add(one, "difference", signal.difference());
      add(one, "relative", signal.relative());
      signals.add(one);
    }
    all.add("signals", signals);
    return all;
  }

  /** JSON has no infinite numbers: they are left out. */
  private static void add(JsonObject object, String name, double value) {
    if (Double.isFinite(value)) {
      object.addProperty(name, value);
    }
  }
}
