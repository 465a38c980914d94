package org.robonewbie.team.skill;

/**
 * Gets up: the quick way first, and if the robot still lies after it, the slow and sure way of {@code motions.startGetUp()}. Robots with
 * long legs have quick ways of their own. From a side, which is rare, there is only the slow way.
 */
public final class GetUp {

    private static final double SOON_SECONDS = 6;

    private final Limbs body;
    private boolean quickly;
    private double begunSeconds = Double.NEGATIVE_INFINITY;

    /**
     * Prepares the skill.
     *
     * @param body lies on the ground now and then
     */
    public GetUp(Limbs body) {
        this.body = body;
    }

    /** Begins to get up, unless a motion is still running. */
    public void start() {
        if (!body.motions().isFinished()) {
            return;
        }
        double seconds = body.nao().getTime();
        boolean again = seconds - begunSeconds < SOON_SECONDS;
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
