package org.robonewbie.examples;

import java.util.Comparator;
import java.util.List;
import org.robonewbie.agent.perception.PlayerItem;
import org.robonewbie.agent.policy.file.PolicyFile;
import org.robonewbie.agent.walk.PolicyWalk;
import org.robonewbie.agent.walk.SoccerPolicy;
import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.nao.Vector3;

/**
 * A soccer player that has learned by playing against itself: a policy chooses the velocity of the walk from the positions of ball, goals and
 * opponent. It finds the ball, localises itself and gets up as {@link Agent_BetterSoccer} does.
 *
 * <p>{@code python -m robonewbie.selfplay Match1v1} trains the policy.
 *
 * <p>Ideas: train longer, or with another reward; let two of them play together; kick when the path is clear.
 */
public final class Agent_LearnedSoccer extends Agent_BetterSoccer {

    private final PolicyWalk learnedWalk = new PolicyWalk(PolicyFile.shipped("walk"));
    private final SoccerPolicy policy = new SoccerPolicy(PolicyFile.shipped("duel"), 0, 1);

    /** Creates the agent. */
    public Agent_LearnedSoccer() {}

    /**
     * Starts the robot.
     *
     * @param args options such as {@code --headless}; {@code --help} lists them
     */
    public static void main(String[] args) {
        new Agent_LearnedSoccer().run(args);
    }

    @Override
    protected void bring(Vector3 ball, Vector3 goal) {
        double goalLine = self.field().length() / 2;
        Vector3 opponentGoal = self.pose().fromFrame(new Vector3(goalLine, 0, 0));
        Vector3 ownGoal = self.pose().fromFrame(new Vector3(-goalLine, 0, 0));
        Vector3 opponent = fieldView.opponents().stream()
                .min(Comparator.comparing(PlayerItem::ageSeconds))
                .map(seen -> self.odometry().positionNow(seen))
                .orElse(opponentGoal);
        WalkVelocity wanted = policy.velocity(nao.isFallen(), List.of(ball, opponentGoal, ownGoal, opponent));
        walk.setPolicy(learnedWalk);
        walk.towards(wanted.forward(), wanted.left(), wanted.turn());
    }
}
