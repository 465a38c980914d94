@org.jspecify.annotations.NullMarked
package org.robonewbie.trial.watch;
