/**
 * Execution of a trial with the teams' programs: a challenge for one robot ({@link
 * org.robonewbie.competition.trial.ChallengePlayer}), or a game of two teams with a simulator and a supervisor ({@link
 * org.robonewbie.competition.trial.TrialRunner}).
 *
 * <p><strong>Internal</strong>: not part of the API; may change in any version.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.competition.trial;
