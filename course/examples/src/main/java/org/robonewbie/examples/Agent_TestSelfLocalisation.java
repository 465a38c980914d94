package org.robonewbie.examples;

import org.robonewbie.agent.Agent;
import org.robonewbie.agent.Options;
import org.robonewbie.agent.localisation.SelfLocalisation;
import org.robonewbie.agent.perception.CameraPicture;
import org.robonewbie.agent.perception.CameraTransformation;
import org.robonewbie.nao.geometry.Pose2d;

/**
 * Localises itself on the field while it walks, and compares its estimated pose with the true one.
 *
 * <p>Beginners do not need this. The pose and the field size are determined from goal posts and flags; between
 * sightings, movement is measured with the gyroscope and the legs; see {@link SelfLocalisation}. The studio draws the
 * estimated pose next to the robot.
 */
public final class Agent_TestSelfLocalisation extends Agent {

    private static final String[] WAY = {"walk-forward", "walk-forward", "walk-forward", "turn-left", "turn-left"};

    private final SelfLocalisation self = new SelfLocalisation();
    private int step;
    private int comparisons;
    private double sumOfErrors;
    private double largestError;

    /** Creates the agent. */
    public Agent_TestSelfLocalisation() {
        fieldView.setTransformation(CameraTransformation.KINEMATICS);
    }

    /**
     * Starts the robot.
     *
     * @param args options such as {@code --headless}; {@code --help} lists them
     */
    public static void main(String[] args) {
        new Agent_TestSelfLocalisation().run(args);
    }

    @Override
    protected Options defaults() {
        return Options.none().withPose(-2, 0, 0).withSeconds(60).with("truth", "true");
    }

    @Override
    protected void think() {
        self.update(nao, fieldView);
        Pose2d pose = self.pose();
        nao.publishPose(pose.x(), pose.y(), pose.degrees());
        lookAround.look();
        if (motions.start(WAY[step % WAY.length])) {
            step++;
            log.info("I am at %s", pose);
            log.info("mean error %.3f m, largest %.3f m", sumOfErrors / Math.max(1, comparisons), largestError);
        }
        nao.getVision().flatMap(CameraPicture::truth).ifPresent(truth -> {
            double error = Math.hypot(truth.head().x() - pose.x(), truth.head().y() - pose.y());
            comparisons += self.isKnown() ? 1 : 0;
            sumOfErrors += self.isKnown() ? error : 0;
            largestError = Math.max(largestError, self.isKnown() ? error : 0);
            nao.plot("position error in metres", error);
        });
    }
}
