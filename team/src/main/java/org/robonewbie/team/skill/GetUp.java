package org.robonewbie.team.skill;

/** Gets up sooner than {@code motions.startGetUp()}; only from a side, which is rare, as slowly as that. */
public final class GetUp {

    private final Limbs body;

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
        switch (body.nao().getBodyPosition()) {
            case LYING_ON_BACK -> body.motions().start("quick-stand-up-from-back");
            case LYING_ON_FRONT -> body.motions().start("quick-stand-up-from-front");
            default -> body.motions().startGetUp();
        }
    }
}
