/**
 * What a mechanism tells beside its motion: reactions and multipliers in a state, forces that a
 * motion takes, motion without forces, equilibrium at rest, small motions about a state.
 */
package org.mechservice.solver.analysis;
