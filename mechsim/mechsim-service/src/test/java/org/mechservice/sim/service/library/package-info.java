@NullMarked
package org.mechservice.sim.service.library;

import org.jspecify.annotations.NullMarked;
