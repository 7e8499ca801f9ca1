package org.mechservice.solver.force.law.printed;

import org.mechservice.solver.force.law.PrintedLaw;
import org.mechservice.solver.spatial.Piecewise;
import org.mechservice.solver.spatial.Powers;

/**
 * Printed from its formula; do not edit. PrintedLawsTest compares it with the formula and
 * prints it anew with -Dgolden.write=true.
 */
final class PrintedContact implements PrintedLaw {

  @Override
  public void load(double[] x, double[] c, double[] out) {
    // The load by its formula.
    double r_x = x[0];
    double r_z = x[2];
    double u_x = x[15];
    double u_z = x[17];
    double radius = c[0];
    double stiffness = c[1];
    double exponent = c[4];
    double eps = c[5];
    double friction = c[6];
    double frictionSpeed = c[7];
    double s = c[8];
    double height = c[9];
    double slope = c[10];
    double bend = c[11];
    double law_1 = s - r_x;
    double law_2 = height - r_z;
    double law_3 = law_1 + slope * law_2;
    double law_4 = 1.0 + slope * slope;
    double law_5 = law_4 + bend * law_2;
    double law_6 = 1e-6 * law_4;
    double law_7 = Piecewise.held(Math.abs(law_3));
    double law_8 = Piecewise.held(Math.sqrt(law_4) * (1e-7 * Math.sqrt(law_1 * law_1
        + law_2 * law_2) + 1e-14 * (Math.abs(r_x) + Math.abs(r_z))));
    double law_9 = (law_3 - Piecewise.held(law_3)) / Piecewise.pick(law_7, law_8,
        Piecewise.pick(law_5, law_6, law_6, law_5), 1e300);
    double law_10 = slope - bend * law_9;
    double law_11 = Math.sqrt(1.0 + law_10 * law_10);
    double law_12 = r_z - (height - slope * law_9);
    double law_13 = r_x - (s - law_9);
    double law_14 = Math.sqrt(law_13 * law_13 + law_12 * law_12);
    double law_15 = Piecewise.choose(Piecewise.held(r_z), Piecewise.held(c[12]), -law_14, law_14);
    double law_16 = Piecewise.choose(law_7, law_8, law_10 / law_11, -(law_13 / law_15));
    double law_17 = Piecewise.choose(law_7, law_8, 1.0 / law_11, law_12 / law_15);
    double law_18 = radius - Piecewise.choose(law_7, law_8, (law_12
        - law_10 * law_13) / law_11, law_15);
    double law_19 = u_x * law_16 - u_z * law_17;
    double law_20 = Math.sqrt(law_18 * law_18 + eps * eps);
    double law_21 = Piecewise.choose(law_18, 0.0, 0.0, Powers.power(law_18, exponent));
    double law_22 = Piecewise.choose(eps, 0.0, Piecewise.choose(0.0, law_18, law_18, 0.0),
        Piecewise.choose(0.0, law_18, 0.5 * (law_18 + law_20), eps / (law_20
        - law_18) * (0.5 * eps)));
    double law_23 = stiffness * Piecewise.choose(eps, 0.0, law_21, Powers.power(law_22, exponent));
    double law_24 = c[2] * law_19;
    double law_25 = c[3] * law_19;
    double law_26 = law_22 / law_20 * law_24 + law_23 * law_25 + law_23;
    double law_27 = 0.5 * law_23;
    double law_28 = Math.max(-1.0, Math.min(1.0, law_26 / (1e-300 + law_27)));
    double law_29 = 1.0 + law_28;
    double law_30 = law_29 * law_29 * law_29;
    double law_31 = (63.0 + law_28 * (law_28 * (102.0 + law_28 * (7.0 * law_28 - 42.0))
        - 122.0)) * (law_30 * law_30) * 0.001953125 * law_27 + Math.max(0.0, law_26 - law_27);
    double law_32 = stiffness * law_21;
    double law_33 = Piecewise.choose(eps, 0.0, Piecewise.choose(law_18, 0.0, Piecewise.choose(0.0,
        law_18, Math.max(0.0, 0.5 * law_24), 0.0), Math.max(0.0, law_24 + law_25 * law_32
        + law_32)), law_31);
    double law_34 = u_x * law_17 + u_z * law_16 - x[13] * radius;
    double law_35 = x[16] + radius * (x[12] * law_17 + x[14] * law_16);
    double law_36 = Math.sqrt(law_34 * law_34 + law_35 * law_35 + frictionSpeed * frictionSpeed);
    double law_37 = friction * law_33;
    double law_38 = Piecewise.choose(friction, 0.0, 0.0, -(law_34 / law_36 * law_37));
    double law_39 = Piecewise.choose(friction, 0.0, 0.0, -(law_35 / law_36 * law_37));
    double law_40 = radius * law_39;
    out[0] = law_17 * law_40;
    out[1] = -(radius * law_38);
    out[2] = law_16 * law_40;
    out[3] = law_17 * law_38 - law_16 * law_33;
    out[4] = law_39;
    out[5] = law_16 * law_38 + law_17 * law_33;
    out[6] = 1.0;
  }

  @Override
  public void slopes(double[] x, double[] c, double[] out) {
    // The load by its formula.
    double r_x = x[0];
    double r_z = x[2];
    double omega_x = x[12];
    double omega_z = x[14];
    double u_x = x[15];
    double u_z = x[17];
    double radius = c[0];
    double stiffness = c[1];
    double damping = c[2];
    double chi = c[3];
    double exponent = c[4];
    double eps = c[5];
    double friction = c[6];
    double frictionSpeed = c[7];
    double s = c[8];
    double height = c[9];
    double slope = c[10];
    double bend = c[11];
    double law_1 = s - r_x;
    double law_2 = height - r_z;
    double law_3 = law_1 + slope * law_2;
    double law_4 = 1.0 + slope * slope;
    double law_5 = law_4 + bend * law_2;
    double law_6 = 1e-6 * law_4;
    double law_7 = Piecewise.held(Math.abs(law_3));
    double law_8 = Piecewise.held(Math.sqrt(law_4) * (1e-7 * Math.sqrt(law_1 * law_1
        + law_2 * law_2) + 1e-14 * (Math.abs(r_x) + Math.abs(r_z))));
    double law_9 = Piecewise.pick(law_7, law_8, Piecewise.pick(law_5, law_6, law_6, law_5), 1e300);
    double law_10 = (law_3 - Piecewise.held(law_3)) / law_9;
    double law_11 = slope - bend * law_10;
    double law_12 = Math.sqrt(1.0 + law_11 * law_11);
    double law_13 = r_z - (height - slope * law_10);
    double law_14 = r_x - (s - law_10);
    double law_15 = (law_13 - law_11 * law_14) / law_12;
    double law_16 = 1.0 / law_12;
    double law_17 = law_11 / law_12;
    double law_18 = Math.sqrt(law_14 * law_14 + law_13 * law_13);
    double law_19 = Piecewise.held(r_z);
    double law_20 = Piecewise.held(c[12]);
    double law_21 = Piecewise.choose(law_19, law_20, -law_18, law_18);
    double law_22 = law_14 / law_21;
    double law_23 = law_13 / law_21;
    double law_24 = Piecewise.choose(law_7, law_8, law_17, -law_22);
    double law_25 = Piecewise.choose(law_7, law_8, law_16, law_23);
    double law_26 = radius - Piecewise.choose(law_7, law_8, law_15, law_21);
    double law_27 = u_x * law_24 - u_z * law_25;
    double law_28 = Math.sqrt(law_26 * law_26 + eps * eps);
    double law_29 = Piecewise.choose(law_26, 0.0, 0.0, Powers.power(law_26, exponent));
    double law_30 = law_28 - law_26;
    double law_31 = eps / law_30;
    double law_32 = 0.5 * eps;
    double law_33 = Piecewise.choose(eps, 0.0, Piecewise.choose(0.0, law_26, law_26, 0.0),
        Piecewise.choose(0.0, law_26, 0.5 * (law_26 + law_28), law_31 * law_32));
    double law_34 = stiffness * Piecewise.choose(eps, 0.0, law_29, Powers.power(law_33, exponent));
    double law_35 = law_33 / law_28;
    double law_36 = damping * law_27;
    double law_37 = chi * law_27;
    double law_38 = law_35 * law_36 + law_34 * law_37 + law_34;
    double law_39 = 0.5 * law_34;
    double law_40 = 1e-300 + law_39;
    double law_41 = law_38 / law_40;
    double law_42 = Math.min(1.0, law_41);
    double law_43 = Math.max(-1.0, law_42);
    double law_44 = 1.0 + law_43;
    double law_45 = law_44 * law_44;
    double law_46 = law_44 * law_45;
    double law_47 = 7.0 * law_43 - 42.0;
    double law_48 = 102.0 + law_43 * law_47;
    double law_49 = law_43 * law_48 - 122.0;
    double law_50 = 63.0 + law_43 * law_49;
    double law_51 = law_46 * law_46;
    double law_52 = law_50 * law_51 * 0.001953125;
    double law_53 = law_38 - law_39;
    double law_54 = stiffness * law_29;
    double law_55 = law_36 + law_37 * law_54 + law_54;
    double law_56 = 0.5 * law_36;
    double law_57 = Piecewise.choose(eps, 0.0, Piecewise.choose(law_26, 0.0, Piecewise.choose(0.0,
        law_26, Math.max(0.0, law_56), 0.0), Math.max(0.0, law_55)), law_39 * law_52
        + Math.max(0.0, law_53));
    double law_58 = u_x * law_25 + u_z * law_24 - x[13] * radius;
    double law_59 = x[16] + radius * (omega_x * law_25 + omega_z * law_24);
    double law_60 = Math.sqrt(law_58 * law_58 + law_59 * law_59 + frictionSpeed * frictionSpeed);
    double law_61 = friction * law_57;
    double law_62 = law_58 / law_60;
    double law_63 = Piecewise.choose(friction, 0.0, 0.0, -(law_61 * law_62));
    double law_64 = law_59 / law_60;
    double law_65 = radius * Piecewise.choose(friction, 0.0, 0.0, -(law_61 * law_64));

    // Derivatives by motion 4.
    double by4_1 = 1.0 / law_9;
    double by4_2 = slope * by4_1;
    double by4_3 = law_13 * by4_2;
    double by4_4 = 1.0 - by4_1;
    double by4_5 = law_14 * by4_4;
    double by4_6 = 0.5 * (by4_5 + by4_5 - (by4_3 + by4_3)) / law_18;
    double by4_7 = Piecewise.choose(law_19, law_20, -by4_6, by4_6);
    double by4_8 = bend * by4_1;
    double by4_9 = law_11 * by4_8;
    double by4_10 = 0.5 * (by4_9 + by4_9) / law_12;
    double by4_11 = Piecewise.choose(law_7, law_8, (by4_8 - law_17 * by4_10) / law_12, -((by4_4
        - law_22 * by4_7) / law_21));
    double by4_12 = Piecewise.choose(law_7, law_8, -(law_16 * by4_10 / law_12), -((by4_2
        + law_23 * by4_7) / law_21));
    double by4_13 = radius * (omega_z * by4_11 + omega_x * by4_12);
    double by4_14 = law_59 * by4_13;
    double by4_15 = u_z * by4_11 + u_x * by4_12;
    double by4_16 = law_58 * by4_15;
    double by4_17 = 0.5 * (by4_14 + by4_14 + (by4_16 + by4_16)) / law_60;
    double by4_18 = Piecewise.choose(law_7, law_8, -((law_14 * by4_8 + law_11 * by4_4 + by4_2
        + law_15 * by4_10) / law_12), by4_7);
    double by4_19 = law_26 * by4_18;
    double by4_20 = 0.5 * (by4_19 + by4_19) / law_28;
    double by4_21 = Piecewise.choose(eps, 0.0, Piecewise.choose(0.0, law_26,
        -by4_18, 0.0), Piecewise.choose(0.0, law_26, -(0.5 * (by4_18 + by4_20)), -(law_31 * (by4_18
        - by4_20) / law_30 * law_32)));
    double by4_22 = exponent - 1.0;
    double by4_23 = Piecewise.product(exponent, Powers.power(law_33, by4_22));
    double by4_24 = Piecewise.product(exponent, Powers.power(law_26, by4_22));
    double by4_25 = Piecewise.choose(law_26, 0.0, 0.0, -(by4_18 * by4_24));
    double by4_26 = stiffness * Piecewise.choose(eps, 0.0, by4_25, by4_21 * by4_23);
    double by4_27 = 0.5 * by4_26;
    double by4_28 = u_x * by4_11 - u_z * by4_12;
    double by4_29 = chi * by4_28;
    double by4_30 = damping * by4_28;
    double by4_31 = law_37 * by4_26 + law_34 * by4_29 + ((by4_21
        + law_35 * by4_20) / law_28 * law_36 + law_35 * by4_30) + by4_26;
    double by4_32 = Piecewise.choose(law_42, -1.0, 0.0, Piecewise.choose(1.0, law_41, 0.0, (by4_31
        - law_41 * by4_27) / law_40));
    double by4_33 = law_44 * by4_32;
    double by4_34 = law_46 * (law_45 * by4_32 + law_44 * (by4_33 + by4_33));
    double by4_35 = law_51 * (law_49 * by4_32 + law_43 * (law_48 * by4_32
        + law_43 * (law_47 * by4_32 + 7.0 * by4_32 * law_43))) + law_50 * (by4_34 + by4_34);
    double by4_36 = stiffness * by4_25;
    double by4_37 = Piecewise.choose(law_26, 0.0, Piecewise.choose(0.0, law_26,
        Piecewise.choose(law_56, 0.0, 0.0, 0.5 * by4_30), 0.0), Piecewise.choose(law_55, 0.0, 0.0,
        law_54 * by4_29 + law_37 * by4_36 + by4_30 + by4_36));
    double by4_38 = Piecewise.choose(eps, 0.0, by4_37, law_52 * by4_27
        + 0.001953125 * by4_35 * law_39 + Piecewise.choose(law_53, 0.0, 0.0, by4_31 - by4_27));
    double by4_39 = friction * by4_38;
    double by4_40 = Piecewise.choose(friction, 0.0, 0.0, -(law_64 * by4_39 + (by4_13
        - law_64 * by4_17) / law_60 * law_61));
    double by4_41 = radius * by4_40;
    double by4_42 = Piecewise.choose(friction, 0.0, 0.0, -(law_62 * by4_39 + (by4_15
        - law_62 * by4_17) / law_60 * law_61));
    out[3] = law_65 * by4_12 + law_25 * by4_41;
    out[15] = -(radius * by4_42);
    out[27] = law_65 * by4_11 + law_24 * by4_41;
    out[39] = law_63 * by4_12 + law_25 * by4_42 - (law_57 * by4_11 + law_24 * by4_38);
    out[51] = by4_40;
    out[63] = law_57 * by4_12 + law_25 * by4_38 + (law_63 * by4_11 + law_24 * by4_42);

    // Derivatives by motion 6.
    double by6_1 = slope / law_9;
    double by6_2 = 1.0 - slope * by6_1;
    double by6_3 = law_13 * by6_2;
    double by6_4 = law_14 * by6_1;
    double by6_5 = 0.5 * (by6_3 + by6_3 - (by6_4 + by6_4)) / law_18;
    double by6_6 = Piecewise.choose(law_19, law_20, -by6_5, by6_5);
    double by6_7 = bend * by6_1;
    double by6_8 = law_11 * by6_7;
    double by6_9 = 0.5 * (by6_8 + by6_8) / law_12;
    double by6_10 = Piecewise.choose(law_7, law_8, (by6_7 - law_17 * by6_9) / law_12, (by6_1
        + law_22 * by6_6) / law_21);
    double by6_11 = Piecewise.choose(law_7, law_8, -(law_16 * by6_9 / law_12), (by6_2
        - law_23 * by6_6) / law_21);
    double by6_12 = radius * (omega_z * by6_10 + omega_x * by6_11);
    double by6_13 = law_59 * by6_12;
    double by6_14 = u_z * by6_10 + u_x * by6_11;
    double by6_15 = law_58 * by6_14;
    double by6_16 = 0.5 * (by6_13 + by6_13 + (by6_15 + by6_15)) / law_60;
    double by6_17 = Piecewise.choose(law_7, law_8, (by6_2 - (law_14 * by6_7 - law_11 * by6_1)
        - law_15 * by6_9) / law_12, by6_6);
    double by6_18 = law_26 * by6_17;
    double by6_19 = 0.5 * (by6_18 + by6_18) / law_28;
    double by6_20 = Piecewise.choose(eps, 0.0, Piecewise.choose(0.0, law_26,
        -by6_17, 0.0), Piecewise.choose(0.0, law_26, -(0.5 * (by6_17 + by6_19)), -(law_31 * (by6_17
        - by6_19) / law_30 * law_32)));
    double by6_21 = Piecewise.choose(law_26, 0.0, 0.0, -(by4_24 * by6_17));
    double by6_22 = stiffness * Piecewise.choose(eps, 0.0, by6_21, by4_23 * by6_20);
    double by6_23 = 0.5 * by6_22;
    double by6_24 = u_x * by6_10 - u_z * by6_11;
    double by6_25 = chi * by6_24;
    double by6_26 = damping * by6_24;
    double by6_27 = law_37 * by6_22 + law_34 * by6_25 + ((by6_20
        + law_35 * by6_19) / law_28 * law_36 + law_35 * by6_26) + by6_22;
    double by6_28 = Piecewise.choose(law_42, -1.0, 0.0, Piecewise.choose(1.0, law_41, 0.0, (by6_27
        - law_41 * by6_23) / law_40));
    double by6_29 = law_44 * by6_28;
    double by6_30 = law_46 * (law_45 * by6_28 + law_44 * (by6_29 + by6_29));
    double by6_31 = law_51 * (law_49 * by6_28 + law_43 * (law_48 * by6_28
        + law_43 * (law_47 * by6_28 + 7.0 * by6_28 * law_43))) + law_50 * (by6_30 + by6_30);
    double by6_32 = stiffness * by6_21;
    double by6_33 = Piecewise.choose(law_26, 0.0, Piecewise.choose(0.0, law_26,
        Piecewise.choose(law_56, 0.0, 0.0, 0.5 * by6_26), 0.0), Piecewise.choose(law_55, 0.0, 0.0,
        law_54 * by6_25 + law_37 * by6_32 + by6_26 + by6_32));
    double by6_34 = Piecewise.choose(eps, 0.0, by6_33, law_52 * by6_23
        + 0.001953125 * by6_31 * law_39 + Piecewise.choose(law_53, 0.0, 0.0, by6_27 - by6_23));
    double by6_35 = friction * by6_34;
    double by6_36 = Piecewise.choose(friction, 0.0, 0.0, -(law_64 * by6_35 + (by6_12
        - law_64 * by6_16) / law_60 * law_61));
    double by6_37 = radius * by6_36;
    double by6_38 = Piecewise.choose(friction, 0.0, 0.0, -(law_62 * by6_35 + (by6_14
        - law_62 * by6_16) / law_60 * law_61));
    out[5] = law_65 * by6_11 + law_25 * by6_37;
    out[17] = -(radius * by6_38);
    out[29] = law_65 * by6_10 + law_24 * by6_37;
    out[41] = law_63 * by6_11 + law_25 * by6_38 - (law_57 * by6_10 + law_24 * by6_34);
    out[53] = by6_36;
    out[65] = law_57 * by6_11 + law_25 * by6_34 + (law_63 * by6_10 + law_24 * by6_38);

    // Derivatives by motion 7.
    double by7_1 = radius * law_25;
    double by7_2 = law_59 * by7_1;
    double by7_3 = 0.5 * (by7_2 + by7_2) / law_60;
    double by7_4 = Piecewise.choose(friction, 0.0, 0.0, -((by7_1
        - law_64 * by7_3) / law_60 * law_61));
    double by7_5 = radius * by7_4;
    double by7_6 = Piecewise.choose(friction, 0.0, 0.0, law_62 * by7_3 / law_60 * law_61);
    out[6] = law_25 * by7_5;
    out[18] = -(radius * by7_6);
    out[30] = law_24 * by7_5;
    out[42] = law_25 * by7_6;
    out[54] = by7_4;
    out[66] = law_24 * by7_6;

    // Derivatives by motion 8.
    double by8_1 = radius * law_58;
    double by8_2 = 0.5 * (by8_1 + by8_1) / law_60;
    double by8_3 = Piecewise.choose(friction, 0.0, 0.0, -(law_64 * by8_2 / law_60 * law_61));
    double by8_4 = radius * by8_3;
    double by8_5 = Piecewise.choose(friction, 0.0, 0.0, -((law_62 * by8_2
        - radius) / law_60 * law_61));
    out[7] = law_25 * by8_4;
    out[19] = -(radius * by8_5);
    out[31] = law_24 * by8_4;
    out[43] = law_25 * by8_5;
    out[55] = by8_3;
    out[67] = law_24 * by8_5;

    // Derivatives by motion 9.
    double by9_1 = radius * law_24;
    double by9_2 = law_59 * by9_1;
    double by9_3 = 0.5 * (by9_2 + by9_2) / law_60;
    double by9_4 = Piecewise.choose(friction, 0.0, 0.0, -((by9_1
        - law_64 * by9_3) / law_60 * law_61));
    double by9_5 = radius * by9_4;
    double by9_6 = Piecewise.choose(friction, 0.0, 0.0, law_62 * by9_3 / law_60 * law_61);
    out[8] = law_25 * by9_5;
    out[20] = -(radius * by9_6);
    out[32] = law_24 * by9_5;
    out[44] = law_25 * by9_6;
    out[56] = by9_4;
    out[68] = law_24 * by9_6;

    // Derivatives by motion 10.
    double by10_1 = law_25 * law_58;
    double by10_2 = 0.5 * (by10_1 + by10_1) / law_60;
    double by10_3 = chi * law_24;
    double by10_4 = damping * law_24;
    double by10_5 = law_34 * by10_3 + law_35 * by10_4;
    double by10_6 = Piecewise.choose(law_42, -1.0, 0.0, Piecewise.choose(1.0, law_41, 0.0, by10_5
        / law_40));
    double by10_7 = law_44 * by10_6;
    double by10_8 = law_46 * (law_45 * by10_6 + law_44 * (by10_7 + by10_7));
    double by10_9 = law_51 * (law_49 * by10_6 + law_43 * (law_48 * by10_6
        + law_43 * (law_47 * by10_6 + 7.0 * by10_6 * law_43))) + law_50 * (by10_8 + by10_8);
    double by10_10 = Piecewise.choose(law_26, 0.0, Piecewise.choose(0.0, law_26,
        Piecewise.choose(law_56, 0.0, 0.0, 0.5 * by10_4), 0.0), Piecewise.choose(law_55, 0.0, 0.0,
        by10_4 + law_54 * by10_3));
    double by10_11 = Piecewise.choose(eps, 0.0, by10_10, Piecewise.choose(law_53, 0.0, 0.0, by10_5)
        + 0.001953125 * by10_9 * law_39);
    double by10_12 = friction * by10_11;
    double by10_13 = Piecewise.choose(friction, 0.0, 0.0, law_64 * by10_2 / law_60 * law_61
        - law_64 * by10_12);
    double by10_14 = radius * by10_13;
    double by10_15 = Piecewise.choose(friction, 0.0, 0.0, -(law_62 * by10_12 + (law_25
        - law_62 * by10_2) / law_60 * law_61));
    out[9] = law_25 * by10_14;
    out[21] = -(radius * by10_15);
    out[33] = law_24 * by10_14;
    out[45] = law_25 * by10_15 - law_24 * by10_11;
    out[57] = by10_13;
    out[69] = law_25 * by10_11 + law_24 * by10_15;

    // Derivatives by motion 11.
    double by11_1 = 0.5 * (law_59 + law_59) / law_60;
    double by11_2 = Piecewise.choose(friction, 0.0, 0.0, -((1.0
        - law_64 * by11_1) / law_60 * law_61));
    double by11_3 = radius * by11_2;
    double by11_4 = Piecewise.choose(friction, 0.0, 0.0, law_62 * by11_1 / law_60 * law_61);
    out[10] = law_25 * by11_3;
    out[22] = -(radius * by11_4);
    out[34] = law_24 * by11_3;
    out[46] = law_25 * by11_4;
    out[58] = by11_2;
    out[70] = law_24 * by11_4;

    // Derivatives by motion 12.
    double by12_1 = law_24 * law_58;
    double by12_2 = 0.5 * (by12_1 + by12_1) / law_60;
    double by12_3 = chi * law_25;
    double by12_4 = damping * law_25;
    double by12_5 = law_34 * by12_3 + law_35 * by12_4;
    double by12_6 = Piecewise.choose(law_42, -1.0, 0.0, Piecewise.choose(1.0, law_41, 0.0,
        -(by12_5 / law_40)));
    double by12_7 = law_44 * by12_6;
    double by12_8 = law_46 * (law_45 * by12_6 + law_44 * (by12_7 + by12_7));
    double by12_9 = law_51 * (law_49 * by12_6 + law_43 * (law_48 * by12_6
        + law_43 * (law_47 * by12_6 + 7.0 * by12_6 * law_43))) + law_50 * (by12_8 + by12_8);
    double by12_10 = Piecewise.choose(law_26, 0.0, Piecewise.choose(0.0, law_26,
        Piecewise.choose(law_56, 0.0, 0.0, -(0.5 * by12_4)), 0.0), Piecewise.choose(law_55, 0.0,
        0.0, -(by12_4 + law_54 * by12_3)));
    double by12_11 = Piecewise.choose(eps, 0.0, by12_10, Piecewise.choose(law_53, 0.0, 0.0, -by12_5)
        + 0.001953125 * by12_9 * law_39);
    double by12_12 = friction * by12_11;
    double by12_13 = Piecewise.choose(friction, 0.0, 0.0, law_64 * by12_2 / law_60 * law_61
        - law_64 * by12_12);
    double by12_14 = radius * by12_13;
    double by12_15 = Piecewise.choose(friction, 0.0, 0.0, -(law_62 * by12_12 + (law_24
        - law_62 * by12_2) / law_60 * law_61));
    out[11] = law_25 * by12_14;
    out[23] = -(radius * by12_15);
    out[35] = law_24 * by12_14;
    out[47] = law_25 * by12_15 - law_24 * by12_11;
    out[59] = by12_13;
    out[71] = law_25 * by12_11 + law_24 * by12_15;
  }

  @Override
  public void results(double[] x, double[] c, double[] out) {
    // The load by its formula.
    double r_x = x[0];
    double r_z = x[2];
    double u_x = x[15];
    double u_z = x[17];
    double radius = c[0];
    double stiffness = c[1];
    double exponent = c[4];
    double eps = c[5];
    double friction = c[6];
    double frictionSpeed = c[7];
    double s = c[8];
    double height = c[9];
    double slope = c[10];
    double bend = c[11];
    double law_1 = s - r_x;
    double law_2 = height - r_z;
    double law_3 = law_1 + slope * law_2;
    double law_4 = 1.0 + slope * slope;
    double law_5 = law_4 + bend * law_2;
    double law_6 = 1e-6 * law_4;
    double law_7 = Piecewise.held(Math.abs(law_3));
    double law_8 = Piecewise.held(Math.sqrt(law_4) * (1e-7 * Math.sqrt(law_1 * law_1
        + law_2 * law_2) + 1e-14 * (Math.abs(r_x) + Math.abs(r_z))));
    double law_9 = (law_3 - Piecewise.held(law_3)) / Piecewise.pick(law_7, law_8,
        Piecewise.pick(law_5, law_6, law_6, law_5), 1e300);
    double law_10 = slope - bend * law_9;
    double law_11 = Math.sqrt(1.0 + law_10 * law_10);
    double law_12 = r_z - (height - slope * law_9);
    double law_13 = r_x - (s - law_9);
    double law_14 = Math.sqrt(law_13 * law_13 + law_12 * law_12);
    double law_15 = Piecewise.choose(Piecewise.held(r_z), Piecewise.held(c[12]), -law_14, law_14);
    double law_16 = Piecewise.choose(law_7, law_8, law_10 / law_11, -(law_13 / law_15));
    double law_17 = Piecewise.choose(law_7, law_8, 1.0 / law_11, law_12 / law_15);
    double law_18 = radius - Piecewise.choose(law_7, law_8, (law_12
        - law_10 * law_13) / law_11, law_15);
    double law_19 = u_x * law_16 - u_z * law_17;
    double law_20 = eps * eps;
    double law_21 = Math.sqrt(law_18 * law_18 + law_20);
    double law_22 = Piecewise.choose(law_18, 0.0, 0.0, Powers.power(law_18, exponent));
    double law_23 = Piecewise.choose(eps, 0.0, Piecewise.choose(0.0, law_18, law_18, 0.0),
        Piecewise.choose(0.0, law_18, 0.5 * (law_18 + law_21), eps / (law_21
        - law_18) * (0.5 * eps)));
    double law_24 = stiffness * Piecewise.choose(eps, 0.0, law_22, Powers.power(law_23, exponent));
    double law_25 = c[2] * law_19;
    double law_26 = c[3] * law_19;
    double law_27 = law_23 / law_21 * law_25 + law_24 * law_26 + law_24;
    double law_28 = 0.5 * law_24;
    double law_29 = Math.max(-1.0, Math.min(1.0, law_27 / (1e-300 + law_28)));
    double law_30 = 1.0 + law_29;
    double law_31 = law_30 * law_30 * law_30;
    double law_32 = (63.0 + law_29 * (law_29 * (102.0 + law_29 * (7.0 * law_29 - 42.0))
        - 122.0)) * (law_31 * law_31) * 0.001953125 * law_28 + Math.max(0.0, law_27 - law_28);
    double law_33 = stiffness * law_22;
    double law_34 = Piecewise.choose(eps, 0.0, Piecewise.choose(law_18, 0.0, Piecewise.choose(0.0,
        law_18, Math.max(0.0, 0.5 * law_25), 0.0), Math.max(0.0, law_25 + law_26 * law_33
        + law_33)), law_32);
    double law_35 = u_x * law_17 + u_z * law_16 - x[13] * radius;
    double law_36 = x[16] + radius * (x[12] * law_17 + x[14] * law_16);
    double law_37 = Math.sqrt(law_35 * law_35 + law_36 * law_36 + frictionSpeed * frictionSpeed);
    double law_38 = friction * law_34;
    double law_39 = Piecewise.choose(friction, 0.0, 0.0, -(law_35 / law_37 * law_38));
    double law_40 = Piecewise.choose(friction, 0.0, 0.0, -(law_36 / law_37 * law_38));
    double law_41 = law_23 * law_23;
    double law_42 = 0.5 * law_41;
    double law_43 = 0.25 * law_20;
    double law_44 = exponent - 1.0;
    double law_45 = Powers.power(law_23, law_44);
    double law_46 = Piecewise.choose(exponent, 1.0, Piecewise.choose(eps, 0.0, law_42, law_42
        + (StrictMath.log(2.0 / eps * law_23) - 0.5) * law_43), law_43 / law_44 * law_45
        + 1.0 / (1.0 + exponent) * (law_41 * law_45));
    out[0] = stiffness * law_46;
    out[1] = law_35 * law_39 + law_36 * law_40 - law_19 * (law_34 - law_24);
    out[2] = law_18;
    out[3] = law_34;
    out[4] = law_39;
    out[5] = law_40;
  }
}
