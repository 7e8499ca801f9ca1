package org.mechservice.cli.simulate;

import java.util.Locale;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import me.tongfei.progressbar.ConsoleProgressBarConsumer;
import me.tongfei.progressbar.ProgressBar;
import me.tongfei.progressbar.ProgressBarBuilder;
import me.tongfei.progressbar.ProgressBarStyle;
import org.jspecify.annotations.Nullable;
import org.mechservice.client.run.RunProgress;

/** A bar on the terminal for set-ups and runs that take longer than a second. */
final class ProgressDisplay {
  /** Set by the launcher when standard error is a terminal; Java cannot ask. */
  private static final boolean TERMINAL = Boolean.getBoolean("mech.terminal");

  private static final long PATIENCE_MILLIS = 1000;
  private static final long TICK_MILLIS = 200;
  private static final int WIDTH = 79;
  private static final int FULL = 1000;

  private final RunFollower news;
  private final ScheduledExecutorService thread;
  private @Nullable ProgressBar bar;

  private ProgressDisplay(RunFollower news, ScheduledExecutorService thread) {
    this.news = news;
    this.thread = thread;
  }

  /**
   * Starts to watch a run.
   *
   * @param wanted whether a bar may be shown at all
   */
  static ProgressDisplay of(RunFollower news, boolean wanted) {
    return of(news, wanted, ProgressDisplay::show);
  }

  @SuppressWarnings("FutureReturnValueIgnored") // the display ends with its thread
  private static ProgressDisplay of(
      RunFollower news, boolean wanted, Consumer<ProgressDisplay> shows) {
    ScheduledExecutorService thread =
        Executors.newSingleThreadScheduledExecutor(
            task -> {
              Thread ticker = new Thread(task, "progress");
              ticker.setDaemon(true);
              return ticker;
            });
    ProgressDisplay display = new ProgressDisplay(news, thread);
    if (wanted && TERMINAL) {
      thread.scheduleAtFixedRate(
          () -> shows.accept(display), PATIENCE_MILLIS, TICK_MILLIS, TimeUnit.MILLISECONDS);
    }
    return display;
  }

  /**
   * Starts to say that a model is being set up, and for how long it has been.
   *
   * @param wanted whether this may be shown at all
   */
  static ProgressDisplay ofSetUp(boolean wanted) {
    return of(new RunFollower(said -> {}), wanted, ProgressDisplay::showSetUp);
  }

  private synchronized void showSetUp() {
    ProgressBar shown = bar == null ? elapsing() : bar;
    bar = shown;
    shown.refresh();
  }

  /** Returns a bar without end, which shows the time. */
  private static ProgressBar elapsing() {
    return new ProgressBarBuilder()
        .setTaskName("setting up")
        .setInitialMax(-1)
        .setStyle(ProgressBarStyle.ASCII)
        .hideEta()
        .setConsumer(new ConsoleProgressBarConsumer(System.err, WIDTH))
        .clearDisplayOnFinish()
        .build();
  }

  private synchronized void show() {
    news.latest().ifPresent(this::show);
  }

  private void show(RunProgress progress) {
    ProgressBar shown = bar == null ? opened() : bar;
    bar = shown;
    shown.stepTo(Math.round(FULL * progress.fraction()));
    shown.setExtraMessage(
        progress.queuePosition() > 0
            ? "waiting, place " + progress.queuePosition() + " in the queue"
            : String.format(
                Locale.ROOT,
                "t=%.4g of %.4g s, step %.2g s",
                progress.time(),
                progress.endTime(),
                progress.stepSize()));
  }

  private static ProgressBar opened() {
    return new ProgressBarBuilder()
        .setInitialMax(FULL)
        .setStyle(ProgressBarStyle.ASCII)
        .hideEta()
        .setConsumer(new ConsoleProgressBarConsumer(System.err, WIDTH))
        .clearDisplayOnFinish()
        .build();
  }

  /** Takes the bar away. */
  void close() {
    thread.shutdownNow();
    synchronized (this) {
      if (bar != null) {
        bar.close();
      }
    }
  }
}
