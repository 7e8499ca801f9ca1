@NullMarked
package org.mechservice.sim.service.run;

import org.jspecify.annotations.NullMarked;
