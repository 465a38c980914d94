package student;

import org.robonewbie.agent.Agent;
import org.robonewbie.agent.Robot;
import org.robonewbie.nao.Joint;

/** A program with the mistakes that beginners make; the tests want to read its line numbers. */
public final class Careless extends Agent {

    private final Mistake mistake;

    /** One thing that a beginner does wrong. */
    public interface Mistake {
        /** Makes the mistake. */
        void make(Robot nao);
    }

    /** Creates an agent that makes a mistake in each cycle. */
    public Careless(Mistake mistake) {
        this.mistake = mistake;
    }

    @Override
    protected void think() {
        mistake.make(nao);
    }

    /** Divides by zero and gives the result to a motor. */
    public static void speedNaN(Robot nao) {
        double nothing = nao.getGyro().x();
        nao.setJointSpeed(Joint.LEFT_KNEE_PITCH, nothing / nao.getGyro().z());
    }

    /** Bends the knee to the wrong side. */
    public static void beyondRange(Robot nao) {
        nao.setJointAngle(Joint.LEFT_KNEE_PITCH, 200);
    }

    /** Forgets that arrays end. */
    public static void exception(Robot nao) {
        int[] numbers = new int[Joint.COUNT];
        nao.setJointSpeed(Joint.NECK_YAW, numbers[numbers.length]);
    }

    /** Talks too much. */
    public static void longSpeech(Robot nao) {
        nao.say("this-is-much-longer-than-allowed");
    }
}
