package org.mechservice.admin;

import java.time.Duration;
import java.time.Instant;
import java.time.ZoneOffset;
import java.util.Locale;
import org.mechservice.idl.NameValue;
import org.mechservice.idl.Progress;
import org.mechservice.orb.tls.TlsIdentity;

/** Writes numbers with their units for people. */
public final class QuantityText {
  private static final double MEBIBYTE = 1024.0 * 1024.0;

  private QuantityText() {}

  /** Returns a text in which numbers have a point, whatever the language of the system. */
  static String format(String pattern, Object... values) {
    return String.format(Locale.ROOT, pattern, values);
  }

  /** Returns how long something has lasted, in its two largest units. */
  public static String age(long sinceMillis, Instant now) {
    Duration age = Duration.between(Instant.ofEpochMilli(sinceMillis), now);
    if (age.toDays() > 0) {
      return age.toDays() + " d " + age.toHoursPart() + " h";
    } else if (age.toHours() > 0) {
      return age.toHours() + " h " + age.toMinutesPart() + " min";
    } else if (age.toMinutes() > 0) {
      return age.toMinutes() + " min";
    }
    return Math.max(0, age.toSeconds()) + " s";
  }

  /** Returns a number of bytes in MiB. */
  public static String memory(long bytes) {
    return format("%.0f MiB", bytes / MEBIBYTE);
  }

  /** Returns a share of processors in per cent, or a hyphen if it is not known. */
  public static String load(double share) {
    return share < 0 ? "-" : format("%.0f %%", 100 * share);
  }

  /** Returns a number in four digits, or a hyphen if it is not finite. */
  public static String number(double value) {
    return Double.isFinite(value) ? format("%.4g", value) : "-";
  }

  /** Returns how far a simulation is, s. */
  public static String time(Progress progress) {
    return number(progress.simTime) + " of " + number(progress.endTime) + " s";
  }

  /**
   * Returns the end of a certificate among a server's or host's statistics: a day, and the time
   * left once it is to be renewed; empty without TLS.
   */
  static String certificate(NameValue[] statistics, Instant now) {
    for (NameValue statistic : statistics) {
      if (statistic.key.equals("certificateExpires")) {
        Instant end = Instant.ofEpochMilli(Long.parseLong(statistic.text));
        String day = end.atZone(ZoneOffset.UTC).toLocalDate().toString();
        if (end.isBefore(now)) {
          return day + " (expired)";
        }
        boolean soon = now.isAfter(end.minus(TlsIdentity.RENEWAL));
        return soon ? day + " (" + Duration.between(now, end).toDays() + " d left)" : day;
      }
    }
    return "";
  }

  /** Returns a time of day in UTC. */
  public static String instant(long millis) {
    return millis == 0 ? "-" : Instant.ofEpochMilli(millis).toString();
  }
}
