/**
 * One trial and the programs of its teams: a challenge for one robot ({@link
 * org.robonewbie.competition.trial.ChallengePlayer}), or a game of two teams with a simulator and an umpire that sees what is
 * true ({@link org.robonewbie.competition.trial.TrialRunner}).
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.competition.trial;
