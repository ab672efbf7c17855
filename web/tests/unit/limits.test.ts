// What the page says of the limits that a show declares: never that all are kept where some were not looked at.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { LimitsKept } from '../../src/data/page';
import { headlineOf } from '../../src/panels/limits';

const kGreatest: LimitsKept['greatest'] = [{ limit: 'height', most: 120, value: 20, bee: 0, time_s: 1 }];

test('limits that are kept are said to be', () => {
  assert.deepEqual(headlineOf({ count: 0, greatest: kGreatest }), { text: 'Greatest speeds, accelerations and height that the show declares: kept.', risky: false });
});

test('stretches beyond limits are counted', () => {
  assert.deepEqual(headlineOf({ count: 1, greatest: kGreatest }), { text: 'Beyond what the show declares: 1 stretch.', risky: true });
  assert.deepEqual(headlineOf({ count: 2, greatest: kGreatest }), { text: 'Beyond what the show declares: 2 stretches.', risky: true });
});

test('limits that were not looked at are named, beside the kept ones and alone', () => {
  assert.deepEqual(headlineOf({ count: 0, greatest: kGreatest, not_looked_at: ['maxAccelerationXY', 'maxYawRate'] }), {
    text: 'Greatest speeds, accelerations and height that the show declares: kept. Declared, but not looked at: maxAccelerationXY, maxYawRate.',
    risky: true,
  });
  assert.deepEqual(headlineOf({ count: 0, greatest: [], not_looked_at: ['minNavAltitude'] }), { text: 'Declared, but not looked at: minNavAltitude.', risky: true });
});
