import org.robonewbie.learning.environment.TrainingTask;
import org.robonewbie.trial.RandomSource;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.WorldState;

/**
 * Task: squat as low as possible without falling. Return: the maximum distance in metres by which the torso has been
 * lowered; 0 after a fall.
 */
public final class Squat extends TrainingTask {

    private double deepest;

    @Override
    public Scene scene(RandomSource random) {
        return Scene.of(RobotStart.at(0, 0).after("stand")).withBall(3, 0);
    }

    @Override
    public double rangeDegrees() {
        return 60;
    }

    @Override
    protected void see(WorldState first, WorldState now) {
        double sunk = first.robot().position().z() - now.robot().position().z();
        deepest = Math.max(deepest, sunk);
    }

    @Override
    public boolean isDone() {
        return !hasFallen() && deepest > 0.1;
    }

    @Override
    public double value() {
        return hasFallen() ? 0 : deepest;
    }
}
