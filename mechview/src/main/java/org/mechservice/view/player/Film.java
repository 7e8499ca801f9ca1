package org.mechservice.view.player;

import com.google.gson.Gson;
import com.google.gson.JsonElement;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * Films and stills of a player's page, taken by the browser of this machine: a still as PNG, a film
 * as MP4, WebM or GIF by ffmpeg.
 *
 * @param width px, even for films
 * @param height px, even for films
 * @param rate pictures a second
 * @param speed simulated seconds in a second of the film; if empty, 1, or less so that a short run
 *     lasts two seconds
 * @param at the time of a still, s; the middle of the run if empty
 * @param view {@code iso}, {@code front}, {@code side} or {@code top}
 * @param show what is drawn besides bodies and joints: {@code forces}, {@code reactions}, {@code
 *     traces}, {@code frames}, {@code inertia}
 * @param dark whether the colours are those of the night
 */
public record Film(
    int width,
    int height,
    double rate,
    OptionalDouble speed,
    OptionalDouble at,
    String view,
    List<String> show,
    boolean dark) {
  public Film {
    show = List.copyOf(show);
  }

  private static final String STILL = ".png";
  private static final List<String> ENDINGS = List.of(STILL, ".mp4", ".webm", ".gif");
  private static final List<String> FFMPEG = List.of("ffmpeg");

  /** A film has so many pictures at most: ten minutes at 30 a second. */
  private static final int MOST_PICTURES = 18_000;

  /** Seconds that a film lasts at least, unless its speed is given. */
  private static final double SHORTEST = 2;

  /** Returns whether a file of this name is a film or a still. */
  public static boolean is(Path target) {
    return ENDINGS.stream().anyMatch(ending(target)::endsWith);
  }

  private static String ending(Path target) {
    return target.toString().toLowerCase(Locale.ROOT);
  }

  /** Returns what this machine lacks to make a file of this name; empty if it lacks nothing. */
  public static Optional<String> lacking(Path target) {
    if (HeadlessBrowser.installed().isEmpty()) {
      return Optional.of("Chromium, and no program of this name is on the path");
    }
    return ending(target).endsWith(STILL) || HeadlessBrowser.program(FFMPEG).isPresent()
        ? Optional.empty()
        : Optional.of("ffmpeg, and no program of this name is on the path");
  }

  /**
   * Takes a still or a film.
   *
   * @param page the player
   * @param from time of the first row, s
   * @param to time of the last row, s
   * @param target the file, on a machine that lacks nothing
   * @throws IOException if a program does not start or fails, or the film would be too long
   */
  public void take(byte[] page, double from, double to, Path target) throws IOException {
    Path file = Files.createTempFile("mech-film", ".html");
    try (HeadlessBrowser browser =
        HeadlessBrowser.start(HeadlessBrowser.installed().orElseThrow())) {
      Files.write(file, page);
      browser.look(width, Math.max(height, 400), dark);
      browser.open(file.toUri(), "Boolean(globalThis.mechPlayer)");
      browser.evaluate(
          "mechPlayer.prepare("
              + width
              + ","
              + height
              + ",'"
              + view
              + "',"
              + new Gson().toJson(show)
              + ")");
      if (ending(target).endsWith(STILL)) {
        double moment = at.orElse((from + to) / 2);
        browser.evaluate("mechPlayer.aim(" + moment + ")");
        Files.write(target, picture(browser, moment, "image/png"));
      } else {
        film(browser, from, to, target);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IOException("the film was interrupted", e);
    } finally {
      Files.deleteIfExists(file);
    }
  }

  private byte[] picture(HeadlessBrowser browser, double time, String type)
      throws IOException, InterruptedException {
    JsonElement taken =
        browser.evaluate(
            "mechPlayer.still(" + time + "," + width + "," + height + ",'" + type + "')");
    String start = "data:" + type + ";base64,";
    if (!taken.isJsonPrimitive() || !taken.getAsString().startsWith(start)) {
      throw new IOException("Chromium makes no picture of " + width + "x" + height + " px");
    }
    return Base64.getDecoder().decode(taken.getAsString().substring(start.length()));
  }

  private void film(HeadlessBrowser browser, double from, double to, Path target)
      throws IOException, InterruptedException {
    double pace = speed.orElse(Math.min(1, (to - from) / SHORTEST));
    int pictures = pace > 0 ? 1 + (int) Math.floor((to - from) / pace * rate * (1 + 1e-9)) : 1;
    if (pictures > MOST_PICTURES) {
      throw new IOException(
          "the film would have "
              + pictures
              + " pictures, and "
              + MOST_PICTURES
              + " are the most; give a greater --speed");
    }
    Path log = Files.createTempFile("mech-film", ".log");
    Process ffmpeg =
        new ProcessBuilder(command(target))
            .redirectErrorStream(true)
            .redirectOutput(log.toFile())
            .start();
    try (OutputStream in = ffmpeg.getOutputStream()) {
      for (int i = 0; i < pictures; i++) {
        in.write(picture(browser, Math.min(to, from + i * pace / rate), "image/jpeg"));
      }
    } catch (IOException e) {
      ffmpeg.destroy();
      throw new IOException("ffmpeg does not take the pictures: " + lastLine(log), e);
    }
    if (ffmpeg.waitFor() != 0) {
      throw new IOException("ffmpeg cannot write " + target + ": " + lastLine(log));
    }
    Files.deleteIfExists(log);
  }

  private static String lastLine(Path log) throws IOException {
    List<String> lines = Files.readAllLines(log);
    return lines.isEmpty() ? "it says nothing" : lines.get(lines.size() - 1);
  }

  private List<String> command(Path target) {
    List<String> words =
        new ArrayList<>(
            List.of(
                "ffmpeg",
                "-y",
                "-loglevel",
                "error",
                "-f",
                "image2pipe",
                "-framerate",
                Double.toString(rate),
                "-c:v",
                "mjpeg",
                "-i",
                "-"));
    if (ending(target).endsWith(".gif")) {
      words.addAll(List.of("-vf", "split[a][b];[a]palettegen[p];[b][p]paletteuse=dither=bayer"));
    } else if (ending(target).endsWith(".webm")) {
      words.addAll(List.of("-c:v", "libvpx-vp9", "-crf", "30", "-b:v", "0", "-pix_fmt", "yuv420p"));
    } else {
      words.addAll(
          List.of(
              "-c:v", "libx264", "-crf", "18", "-pix_fmt", "yuv420p", "-movflags", "+faststart"));
    }
    words.add(target.toString());
    return words;
  }
}
