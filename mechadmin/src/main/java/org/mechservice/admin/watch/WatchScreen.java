package org.mechservice.admin.watch;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import org.jline.utils.AttributedString;
import org.jline.utils.AttributedStringBuilder;
import org.jline.utils.AttributedStyle;
import org.mechservice.admin.HostState;
import org.mechservice.admin.KnownSimulation;
import org.mechservice.admin.PlainText;
import org.mechservice.admin.QuantityText;
import org.mechservice.admin.ServerReading;
import org.mechservice.idl.HostStatus;
import org.mechservice.idl.Progress;
import org.mechservice.idl.SimSummary;

/**
 * The lines of the screen: servers with their hosts above, simulations below, keys in the last
 * line. Pure: what is shown depends on what is given alone.
 */
final class WatchScreen {
  private static final AttributedStyle PLAIN = AttributedStyle.DEFAULT;
  private static final AttributedStyle BOLD = PLAIN.bold();
  private static final AttributedStyle FAINT = PLAIN.faint();
  private static final AttributedStyle GOOD = coloured(AttributedStyle.GREEN);
  private static final AttributedStyle COOL = coloured(AttributedStyle.CYAN);
  private static final AttributedStyle WARN = coloured(AttributedStyle.YELLOW);
  private static final AttributedStyle BAD = coloured(AttributedStyle.RED).bold();
  private static final AttributedStyle HEAD = PLAIN.inverse();

  private static final int BAR = 12;
  private static final int FIXED_LINES = 4;
  private static final String COLUMNS = "%-8s  %-16s  %-10s  %-10s  %-9s  %-17s  %9s  %8s  %s";

  private final int width;
  private final int height;
  private final Instant now;

  /**
   * @param width columns of the terminal
   * @param height lines of the terminal
   * @param now the time from which ages are counted
   */
  WatchScreen(int width, int height, Instant now) {
    this.width = width;
    this.height = height;
    this.now = now;
  }

  /** Returns as many lines as the screen has, none of them wider than it. */
  List<AttributedString> lines(List<ServerReading> readings, WatchState state) {
    List<AttributedString> lines = new ArrayList<>();
    List<KnownSimulation> listed = state.listed(readings);
    lines.add(headline(readings));
    if (state.detail().isPresent()) {
      state.detail().get().stream()
          .limit(Math.max(0, height - 2))
          .forEach(line -> lines.add(styled(PLAIN, line)));
    } else {
      places(readings, Math.max(2, (height - FIXED_LINES) / 2)).forEach(lines::add);
      lines.add(AttributedString.EMPTY);
      simulations(lines, listed, state);
    }
    while (lines.size() < height - 1) {
      lines.add(AttributedString.EMPTY);
    }
    List<AttributedString> fitting = new ArrayList<>(lines.subList(0, height - 1));
    fitting.add(lastLine(listed, state));
    return fitting.stream().map(line -> line.columnSubSequence(0, width)).toList();
  }

  /** Returns plain text in a colour, or without one if the user does not want any: no-color.org. */
  private static AttributedStyle coloured(int colour) {
    String unwanted = System.getenv("NO_COLOR");
    return unwanted == null || unwanted.isEmpty() ? PLAIN.foreground(colour) : PLAIN;
  }

  private static AttributedString styled(AttributedStyle style, String text) {
    return new AttributedString(PlainText.of(text), style);
  }

  private AttributedString headline(List<ServerReading> readings) {
    long up = readings.stream().filter(ServerReading.Answering.class::isInstance).count();
    List<KnownSimulation> all = KnownSimulation.all(readings);
    String text =
        String.format(
            Locale.ROOT,
            " MechAdmin   servers %d of %d up   running %d   queued %d   failed %d   %s",
            up,
            readings.size(),
            count(all, "running"),
            count(all, "queued"),
            count(all, "failed"),
            now.toString().substring(11, 19) + " UTC");
    return new AttributedString(padded(text), HEAD);
  }

  private static long count(List<KnownSimulation> all, String state) {
    return all.stream().filter(known -> known.state().equals(state)).count();
  }

  private String padded(String text) {
    return text + " ".repeat(Math.max(0, width - text.length()));
  }

  private List<AttributedString> places(List<ServerReading> readings, int most) {
    List<AttributedString> lines = new ArrayList<>();
    for (ServerReading reading : readings) {
      if (reading instanceof ServerReading.Answering answering) {
        lines.add(server(answering));
        answering.hosts().forEach(host -> lines.add(host(host)));
      } else if (reading instanceof ServerReading.Silent silent) {
        lines.add(styled(BAD, silent.address() + "  " + silent.label() + "  " + silent.why()));
      } else {
        lines.add(styled(FAINT, reading.address() + "  connecting"));
      }
    }
    if (lines.size() <= most) {
      return lines;
    }
    return Stream.concat(
            lines.stream().limit(most - 1L),
            Stream.of(styled(FAINT, "and " + (lines.size() - most + 1) + " lines more")))
        .toList();
  }

  private AttributedString server(ServerReading.Answering reading) {
    boolean draining = reading.status().draining;
    return new AttributedStringBuilder()
        .append(PlainText.of(reading.name()), BOLD)
        .append("  ")
        .append(draining ? "draining" : "up", draining ? WARN : GOOD)
        .append(
            PlainText.of(
                "  "
                    + reading.address()
                    + "  up "
                    + QuantityText.age(reading.status().info.startedAt, now)
                    + "  sessions "
                    + reading.status().sessions
                    + "  queued "
                    + reading.status().queued))
        .toAttributedString();
  }

  private static AttributedString host(HostStatus host) {
    HostState state = HostState.of(host);
    AttributedStringBuilder line =
        new AttributedStringBuilder()
            .append(cell("  %-18.18s ", PlainText.of(host.info.name)))
            .append(cell("%-10s", state.label()), style(state));
    if (!host.reachable) {
      return line.append(PlainText.of(host.text), FAINT).toAttributedString();
    }
    return line.append("CPU ")
        .append(bar(host.load.cpuLoad), host.load.cpuLoad > 0.9 ? WARN : COOL)
        .append(cell(" %5s  ", QuantityText.load(host.load.cpuLoad)))
        .append(cell("memory %10s  ", QuantityText.memory(host.load.memoryUsed)))
        .append(
            "running "
                + host.load.running
                + " of "
                + host.info.capacity
                + "  queued "
                + host.load.queued)
        .toAttributedString();
  }

  private static String cell(String pattern, Object value) {
    return String.format(Locale.ROOT, pattern, value);
  }

  private static AttributedStyle style(HostState state) {
    return switch (state) {
      case UP -> GOOD;
      case DRAINING -> WARN;
      case SILENT, LOST -> BAD;
    };
  }

  private static String bar(double share) {
    int full = (int) Math.round(BAR * Math.max(0, Math.min(1, share)));
    return "[" + "#".repeat(full) + "-".repeat(BAR - full) + "]";
  }

  private void simulations(
      List<AttributedString> lines, List<KnownSimulation> listed, WatchState state) {
    String heading =
        String.format(
            Locale.ROOT,
            COLUMNS,
            "ID",
            "MODEL",
            "HOST",
            "OWNER",
            "STATE",
            "PROGRESS",
            "X REAL",
            "STEP",
            "LAST MESSAGE");
    lines.add(new AttributedString(padded(heading), BOLD.underline()));
    int room = Math.max(1, height - lines.size() - 1);
    int place = state.place(listed);
    int first = Math.max(0, Math.min(place - room / 2, listed.size() - room));
    for (int i = first; i < Math.min(listed.size(), first + room); i++) {
      lines.add(simulation(listed.get(i), i == place));
    }
    if (listed.isEmpty()) {
      lines.add(styled(FAINT, "none"));
    }
  }

  private AttributedString simulation(KnownSimulation known, boolean chosen) {
    SimSummary summary = known.summary();
    Progress info = summary.info;
    String text =
        String.format(
            Locale.ROOT,
            COLUMNS,
            shortened(summary.simId, 8),
            shortened(summary.modelName, 16),
            shortened(summary.hostName, 10),
            shortened(summary.owner, 10),
            known.state(),
            bar(known.progress()) + QuantityText.load(known.progress()).replace(" %", "%"),
            QuantityText.number(info.realTimeFactor),
            QuantityText.number(info.stepSize),
            PlainText.of(summary.text));
    return new AttributedString(
        chosen ? padded(text) : text, chosen ? style(known).inverse() : style(known));
  }

  private static String shortened(String text, int most) {
    String plain = PlainText.of(text);
    return plain.length() <= most ? plain : plain.substring(0, most);
  }

  private static AttributedStyle style(KnownSimulation known) {
    return switch (known.state()) {
      case "running" -> GOOD;
      case "queued", "created" -> COOL;
      case "paused", "cancelled" -> WARN;
      case "failed" -> BAD;
      default -> PLAIN;
    };
  }

  private AttributedString lastLine(List<KnownSimulation> listed, WatchState state) {
    if (state.asking()) {
      String what =
          state
              .chosen(listed)
              .map(known -> shortened(known.summary().simId, 8) + " " + known.summary().modelName)
              .orElse("");
      return styled(WARN, "Stop " + what + "?  y: yes   any other key: no");
    } else if (state.detail().isPresent()) {
      return styled(FAINT, "↑ ↓ scroll   Esc back");
    } else if (!state.news().isEmpty()) {
      return styled(BOLD, state.news());
    }
    return styled(
        FAINT,
        "↑ ↓ choose   Enter inspect   c cancel   s sort: "
            + state.sort().label()
            + "   r reverse   f show: "
            + state.filter().label()
            + "   q quit");
  }
}
