package org.mechservice.cli.picture;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.mechservice.cli.shell.UsageException;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.view.player.Film;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** How films and pictures of one moment are taken. */
final class FilmOptions {
  private static final Pattern SIZE = Pattern.compile("(\\d{1,5})x(\\d{1,5})");
  private static final int LEAST = 16;
  private static final int MOST = 8192;
  private static final double MOST_RATE = 240;
  private static final List<String> SHOWN =
      List.of("forces", "reactions", "traces", "frames", "inertia");
  private static final List<String> VIEWS = List.of("iso", "front", "side", "top");

  @Option(
      names = "--size",
      paramLabel = "WIDTHxHEIGHT",
      description = "Size of films and pictures, px (default: ${DEFAULT-VALUE}).")
  private String size = "1280x720";

  @Option(
      names = "--fps",
      paramLabel = "N",
      description = "Pictures a second of films (default: ${DEFAULT-VALUE}).")
  private double rate = 30;

  @Option(
      names = "--speed",
      paramLabel = "X",
      description =
          "Simulated seconds in a second of a film (default: 1, or less so that a film lasts two"
              + " seconds).")
  private Optional<Double> speed = Optional.empty();

  @Option(
      names = "--at",
      paramLabel = "SECONDS",
      description = "The moment of a picture (default: the middle of the run).")
  private Optional<Double> at = Optional.empty();

  @Option(
      names = "--view",
      paramLabel = "iso|front|side|top",
      description = "From where films and pictures look (default: ${DEFAULT-VALUE}).")
  private String view = "iso";

  @Option(
      names = "--show",
      split = ",",
      paramLabel = "WHAT",
      hideParamSyntax = true,
      description =
          "What films and pictures show besides bodies and joints: forces, reactions, traces,"
              + " frames, inertia, separated by commas.")
  private List<String> show = List.of();

  @Mixin private DarkOption dark = new DarkOption();

  /**
   * Returns the film.
   *
   * @throws UsageException if a value cannot be used
   */
  Film film() {
    Matcher sizes = SIZE.matcher(size);
    if (!sizes.matches()) {
      throw unusable("--size " + size, "write two numbers of px, such as 1280x720");
    }
    int width = Integer.parseInt(sizes.group(1));
    int height = Integer.parseInt(sizes.group(2));
    if (Math.min(width, height) < LEAST || Math.max(width, height) > MOST) {
      throw unusable("--size " + size, "both numbers are from " + LEAST + " to " + MOST + " px");
    }
    if (width % 2 != 0 || height % 2 != 0) {
      throw unusable("--size " + size, "films need even numbers of px");
    }
    if (!(rate > 0 && rate <= MOST_RATE)) {
      throw unusable("--fps " + rate, "a film has more than 0 and at most 240 pictures a second");
    }
    if (speed.filter(one -> !(one > 0 && Double.isFinite(one))).isPresent()) {
      throw unusable("--speed " + speed.get(), "it must be positive");
    }
    if (!VIEWS.contains(view)) {
      throw unusable("--view " + view, "it is iso, front, side or top");
    }
    for (String what : show) {
      if (!SHOWN.contains(what)) {
        throw unusable("--show " + what, "it is one of " + String.join(", ", SHOWN));
      }
    }
    return new Film(width, height, rate, number(speed), number(at), view, show, dark.isDark());
  }

  private static OptionalDouble number(Optional<Double> value) {
    return value.map(OptionalDouble::of).orElseGet(OptionalDouble::empty);
  }

  private static UsageException unusable(String option, String why) {
    return new UsageException(MessageCode.OPTION_UNUSABLE + " " + option + ": " + why);
  }
}
