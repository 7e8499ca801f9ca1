/**
 * Tables I and II of the paper (Rodríguez et al., Multibody System Dynamics 10, 2003), measured
 * again.
 */
@NullMarked
package org.mechservice.benchmarks.paper;

import org.jspecify.annotations.NullMarked;
