/** From a mechanism to a generated class, its compiled form and the JARs that carry it. */
@NullMarked
package org.mechservice.sim.model;

import org.jspecify.annotations.NullMarked;
