package org.mechservice.spark;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.apache.spark.SparkConf;
import org.apache.spark.api.java.JavaSparkContext;
import org.mechservice.guard.UserCode;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.study.run.StudyForecast;
import org.mechservice.study.run.StudyPlan;
import org.mechservice.study.run.StudyReader;
import org.mechservice.study.run.StudyRows;

/**
 * Runs a study on a Spark cluster: the class that {@code spark-submit} or {@code java} starts. The
 * master and all settings are Spark's own, from its files, options and system properties.
 */
public final class SparkStudy {
  private static final String USAGE = "write STUDY.xml, or STUDY.xml -o TABLE.csv";

  private SparkStudy() {}

  /**
   * The arguments of the command line.
   *
   * @param study on the driver's machine
   * @param table in a file system that driver and executors share
   * @param quiet whether nothing but errors is printed
   * @param userCode the folders whose classes of forces may run
   */
  private record Arguments(Path study, String table, boolean quiet, UserCode userCode) {
    static Arguments of(String... words) {
      Optional<String> study = Optional.empty();
      Optional<String> table = Optional.empty();
      boolean quiet = false;
      boolean unconfined = false;
      List<Path> trusted = new ArrayList<>();
      for (int i = 0; i < words.length; i++) {
        if (words[i].equals("-o") && i + 1 < words.length) {
          table = Optional.of(words[++i]);
        } else if (words[i].equals("--quiet")) {
          quiet = true;
        } else if (words[i].equals("--user-code") && i + 1 < words.length) {
          trusted.add(Path.of(words[++i]));
        } else if (words[i].equals("--unconfined")) {
          unconfined = true;
        } else if (study.isEmpty() && !words[i].startsWith("-")) {
          study = Optional.of(words[i]);
        } else {
          throw refused("\"" + words[i] + "\" is not understood; " + USAGE);
        }
      }
      Path file = Path.of(study.orElseThrow(() -> refused("no study is named; " + USAGE)));
      String name = String.valueOf(file.getFileName()).replaceFirst("\\.[^.]*$", "") + ".csv";
      UserCode named = UserCode.in(trusted.toArray(Path[]::new));
      Arguments arguments =
          new Arguments(file, table.orElse(name), quiet, unconfined ? named.unconfined() : named);
      String ending = arguments.table.toLowerCase(Locale.ROOT);
      if (!ending.endsWith(".csv") && !ending.endsWith(".parquet")) {
        throw refused(
            "-o "
                + arguments.table
                + ": the table of a study is written to a .csv or a .parquet file");
      }
      return arguments;
    }

    private static IllegalArgumentException refused(String why) {
      return new IllegalArgumentException(MessageCode.OPTION_UNUSABLE + " " + why);
    }
  }

  /**
   * Runs a study; ends the process with status 1 or 2 if it cannot.
   *
   * @param words the study's file, {@code -o} with the table, {@code --quiet}, {@code --user-code}
   *     with a folder, {@code --unconfined}
   */
  public static void main(String... words) throws InterruptedException {
    try {
      run(words);
    } catch (IllegalArgumentException | MechmlException e) {
      end(e, 2);
    } catch (IOException e) {
      end(e, 1);
    }
  }

  @SuppressWarnings("SystemOut") // a program of the command line
  private static void end(Exception why, int status) {
    System.err.println(why.getMessage());
    System.exit(status);
  }

  @SuppressWarnings("SystemOut") // a program of the command line
  private static void run(String... words)
      throws IOException, MechmlException, InterruptedException {
    Arguments arguments = Arguments.of(words);
    StudyPlan plan =
        StudyReader.read(arguments.study, Files.readAllBytes(arguments.study), arguments.userCode);
    plan.userCodeWarning().ifPresent(System.err::println);
    SparkConf settings = new SparkConf();
    if (!settings.contains("spark.app.name")) {
      settings.setAppName("mech study " + arguments.study.getFileName());
    }
    try (JavaSparkContext spark = new JavaSparkContext(settings)) {
      StudyRows rows =
          new SparkEngine(spark, arguments.study, plan, arguments.table)
              .run(new ProgressLog(arguments.quiet, plan.points()));
      if (!arguments.quiet) {
        int failed = rows.statistics().failed();
        System.out.println(
            arguments.table
                + ": "
                + rows.taken()
                + " points"
                + (rows.isEndedByRule() ? "; the stop rule ended the study" : "")
                + (failed > 0 ? "; " + failed + " failed: their rows say why" : ""));
        rows.statistics().lines().forEach(line -> System.out.println("  " + line));
      }
    }
  }

  /** Prints the progress of the study; what the first wave has found took no time. */
  private static final class ProgressLog implements SparkEngine.Progress {
    private final boolean quiet;
    private final StudyForecast forecast;
    private int before = -1;

    ProgressLog(boolean quiet, int all) {
      this.quiet = quiet;
      forecast = new StudyForecast(() -> System.nanoTime() * 1e-9, all);
    }

    @Override
    @SuppressWarnings("SystemOut") // a program of the command line
    public void at(int done, int all) {
      before = before < 0 ? done : before;
      forecast.at(done, before, all);
      if (!quiet) {
        forecast.word().ifPresent(System.err::println);
      }
    }
  }
}
