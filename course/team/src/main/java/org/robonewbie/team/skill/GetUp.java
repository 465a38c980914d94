package org.robonewbie.team.skill;

/**
 * Gets up with a quick motion. If the robot is still lying afterwards, it uses the slow but reliable motion of {@code
 * motions.startGetUp()}. Robots with long legs have their own quick motions. A robot that lies on its side, which is rare, uses
 * only the slow motion.
 */
public final class GetUp {

    private static final double RETRY_SECONDS = 6;

    private final Limbs body;
    private boolean quickly;
    private double begunSeconds = Double.NEGATIVE_INFINITY;

    /**
     * Creates the skill.
     *
     * @param body the robot
     */
    public GetUp(Limbs body) {
        this.body = body;
    }

    /** Starts to get up, unless a motion is running. */
    public void start() {
        if (!body.motions().isFinished()) {
            return;
        }
        double seconds = body.nao().getTime();
        boolean again = seconds - begunSeconds < RETRY_SECONDS;
        quickly = !(again && quickly);
        begunSeconds = seconds;
        switch (body.nao().getBodyPosition()) {
            case LYING_ON_BACK -> start("quick-stand-up-from-back");
            case LYING_ON_FRONT -> start("quick-stand-up-from-front");
            default -> body.motions().startGetUp();
        }
    }

    private void start(String quickWay) {
        if (quickly) {
            body.motions().start(body.nao().getType().ownMotion(quickWay));
        } else {
            body.motions().startGetUp();
        }
    }
}
