package org.mechservice.sim.service;

/** Notices whether a run has got on, for those who are told from time to time. Thread-safe. */
final class RunNews {
  private final RunStory story;
  private long stepsTold = -1;
  private int placeTold;

  RunNews(RunStory story) {
    this.story = story;
  }

  /** Returns whether the run has got on, or up in the queue, since this was asked last. */
  synchronized boolean any() {
    int place = story.place();
    boolean movedUp = place > 0 && place != placeTold;
    placeTold = place;
    return movedUp || hasStepped();
  }

  private boolean hasStepped() {
    long steps = story.control().steps();
    boolean stepped = story.phase().runs() && steps != stepsTold;
    stepsTold = steps;
    if (stepped) {
      RunColumnsWatch watch = story.rows().watch();
      story.curves().sample(story.control(), watch.energyDrift(), watch.residual());
    }
    return stepped;
  }
}
