package org.mechservice.study.run;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/** What a study says of its end, by a clock that the test moves. */
class StudyForecastTest {
  private double now = 1000;

  private StudyForecast of(int points) {
    return new StudyForecast(() -> now, points);
  }

  @Test
  void nothingIsSaidBeforeAMinuteNorAtTheEnd() {
    StudyForecast forecast = of(100);
    now += 59.9;
    forecast.at(20, 0, 100);
    assertThat(forecast.word()).isEmpty();
    now += 1;
    forecast.at(100, 0, 100);
    assertThat(forecast.word()).isEmpty();
  }

  /** 6 points a minute of this process: the 40 of an earlier one took none of its time. */
  @Test
  void afterAMinuteItIsSaidHowLongTheStudyWillTake() {
    StudyForecast forecast = of(1_000_046);
    now += 60;
    forecast.at(46, 40, 1_000_046);

    assertThat(forecast.word()).hasValue("46 of 1000046 points; about 116 days left");
    assertThat(forecast.word()).isEmpty();
    now += 299;
    assertThat(forecast.word()).isEmpty();
    now += 1;
    forecast.at(1_000_036, 40, 1_000_046);
    assertThat(forecast.word()).hasValue("1000036 of 1000046 points; about 0 s left");
  }

  @Test
  void durationsAreSaidInUnitsThatFit() {
    assertThat(left(60, 119)).endsWith("about 119 s left");
    assertThat(left(60, 600)).endsWith("about 10 min left");
    assertThat(left(60, 9000)).endsWith("about 2.5 h left");
    assertThat(left(60, 400_000)).endsWith("about 5 days left");
  }

  private String left(int done, int more) {
    StudyForecast forecast = of(done + more);
    now += 60; // a point a second
    forecast.at(done, 0, done + more);
    return forecast.word().orElseThrow();
  }

  /** The first point may take longer than a minute. */
  @Test
  void studyWhoseFirstPointIsNotFinishedSaysThat() {
    StudyForecast forecast = of(9);
    now += 61;

    assertThat(forecast.word())
        .hasValue("0 of 9 points after 61 s; none of this process is finished yet");
  }
}
