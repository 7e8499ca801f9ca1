package org.mechservice.solver.ode.suite;

/**
 * The Brusselator with diffusion on 20 points of a line; state u and v of each point in turn, so
 * that each component couples with the two before and after it. Hairer and Wanner II, IV.1. End
 * value confirmed to 14.8 digits by collocation of order 13 and 17.
 */
public final class Brusselator implements SuiteProblem {
  private static final int POINTS = 20;
  private static final double DIFFUSION = (POINTS + 1) * (POINTS + 1) / 50.0;
  private static final double U_AT_ENDS = 1;
  private static final double V_AT_ENDS = 3;

  private static final VerifiedValues REFERENCE =
      new VerifiedValues(
          10.0,
          initialState(),
          new double[] {
            1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0,
            1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0,
            1.0, 1.0, 1.0, 1.0, 1.0, 1.0
          },
          new double[] {
            0.8776530097283123,
            3.1547039090604367,
            0.765892827383827,
            3.2955488200908687,
            0.6712478470947835,
            3.4136432654868467,
            0.5958550017513676,
            3.505830090092761,
            0.5386469677140998,
            3.573451166362831,
            0.4969386018731104,
            3.62040579138373,
            0.46767208767276525,
            3.6514468675417597,
            0.44813203482007274,
            3.6710454230898857,
            0.4362471260013675,
            3.6827708468618994,
            0.4306606757477103,
            3.6890130427684378,
            0.430711250040271,
            3.6908875512492503,
            0.4364053271659524,
            3.6882193830022727,
            0.44841691838178627,
            3.679556662845482,
            0.4681131789868525,
            3.662214785967886,
            0.49756920417095496,
            3.632401031451001,
            0.5394886457356803,
            3.5855235488192285,
            0.5968897247446976,
            3.5168399755684385,
            0.6723805302574589,
            3.422609112102876,
            0.766922684123681,
            3.301778439248172,
            0.8782943216042928,
            3.1578531172421247
          },
          4.0,
          new double[] {
            0.9011221273213715,
            3.166302970256095,
            0.8088535863445823,
            3.3235249896811254,
            0.7284674226299039,
            3.464405847239217,
            0.6628410821785432,
            3.584864505512389,
            0.6125447768685102,
            3.6839183242017506,
            0.5765853066321958,
            3.762705404790274,
            0.5532531069883438,
            3.8232883345438284,
            0.5407617473853895,
            3.867674391716938,
            0.5376120760126343,
            3.897203528785397,
            0.5427352730514269,
            3.9122880264099327,
            0.5554916210490219,
            3.912431087296631,
            0.5755805409176942,
            3.8964518507323587,
            0.6028909226708007,
            3.862858661228283,
            0.6373071210259743,
            3.8103181948227323,
            0.6784917633156119,
            3.7381560870634605,
            0.7256904803027304,
            3.6467966318156115,
            0.777633528629623,
            3.5380204547441076,
            0.8326190938584237,
            3.4149204370355,
            0.8888241534716147,
            3.2814991747792632,
            0.9447983542248528,
            3.141975770476342
          });

  @Override
  public VerifiedValues reference() {
    return REFERENCE;
  }

  @Override
  public void derivative(double t, double[] y, double[] yDot) {
    for (int i = 0; i < POINTS; i++) {
      double u = y[2 * i];
      double v = y[2 * i + 1];
      yDot[2 * i] = 1 + u * u * v - 4 * u + DIFFUSION * bend(i, 0, U_AT_ENDS, y);
      yDot[2 * i + 1] = 3 * u - u * u * v + DIFFUSION * bend(i, 1, V_AT_ENDS, y);
    }
  }

  /** Second difference at a point. */
  private static double bend(int point, int species, double atEnds, double[] y) {
    int here = 2 * point + species;
    double before = point == 0 ? atEnds : y[here - 2];
    double after = point == POINTS - 1 ? atEnds : y[here + 2];
    return before - 2 * y[here] + after;
  }

  private static double[] initialState() {
    double[] y = new double[2 * POINTS];
    for (int i = 0; i < POINTS; i++) {
      y[2 * i] = 1 + StrictMath.sin(2 * Math.PI * (i + 1) / (POINTS + 1));
      y[2 * i + 1] = V_AT_ENDS;
    }
    return y;
  }
}
