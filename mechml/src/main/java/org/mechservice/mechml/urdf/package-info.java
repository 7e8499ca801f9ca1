/**
 * From URDF, the Unified Robot Description Format, to MechML. What URDF says of masses, joints and
 * frames is carried over; what MechML has no word for is told, place by place.
 */
@NullMarked
package org.mechservice.mechml.urdf;

import org.jspecify.annotations.NullMarked;
