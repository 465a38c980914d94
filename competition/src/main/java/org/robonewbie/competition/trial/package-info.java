/**
 * One trial: a simulator, the programs of the teams, and an umpire that sees what is true. Start reading with {@link org.robonewbie.competition.trial.TrialRunner}.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.competition.trial;
