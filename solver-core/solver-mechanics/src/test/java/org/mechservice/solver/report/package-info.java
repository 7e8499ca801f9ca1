/** Writes pages of docs/reports from large random sets. */
package org.mechservice.solver.report;
