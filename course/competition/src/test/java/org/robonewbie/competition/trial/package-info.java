/** Tests of single trials with real programs. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.competition.trial;
