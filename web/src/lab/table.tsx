// The disks in numbers: cells that can be edited, and what follows from them.
import { NumberField } from '../ui/number-field';
import { shown, shownToAddUp, strings } from '../strings';
import { addDisk, changeDisk, changeMass, disksNow, grid, mostDisks, removeDisk, setup, touched } from './model';

export function DiskTable() {
  const words = strings.value;
  const disks = disksNow.value;
  const px = shownToAddUp(disks.map(({ mass, vx }) => mass * vx));
  const py = shownToAddUp(disks.map(({ mass, vy }) => mass * vy));
  const speedStep = grid.value / setup.value.arrow;
  const marked = (k: number, what: 'place' | 'velocity'): boolean =>
    touched.value?.disk === k && touched.value.what === what;
  return (
    <section class="table-section" aria-label={words.table}>
      <div class="scroller" tabindex={0} role="group" aria-label={words.table}>
        <table>
          <thead>
            <tr>
              <th scope="col">{words.disk}</th>
              <th scope="col" title={words.mass}>m</th>
              <th scope="col" title={words.radius}>R</th>
              <th scope="col" title={words.place}>x</th>
              <th scope="col" title={words.place}>y</th>
              <th scope="col" title={words.velocity}>
                v<sub>x</sub>
              </th>
              <th scope="col" title={words.velocity}>
                v<sub>y</sub>
              </th>
              <th scope="col" title={words.momentum}>
                p<sub>x</sub>
              </th>
              <th scope="col" title={words.momentum}>
                p<sub>y</sub>
              </th>
            </tr>
          </thead>
          <tbody>
            {disks.map((disk, k) => (
              <tr key={k}>
                <th scope="row">
                  <span class={`badge disk-${k % 6}`}>{k + 1}</span>
                </th>
                <td>
                  <NumberField label={words.cell(words.mass, k + 1)} value={disk.mass} step={0.1} least={0.001} most={1e6}
                    change={(mass) => changeMass(k, mass)} />
                </td>
                <td>
                  <NumberField label={words.cell(words.radius, k + 1)} value={disk.radius} step={grid.value} least={grid.value / 100}
                    most={setup.value.height / 2} change={(radius) => changeDisk(k, { radius })} />
                </td>
                <td>
                  <NumberField label={words.cell('x', k + 1)} value={disk.x} step={grid.value} marked={marked(k, 'place')}
                    change={(x) => changeDisk(k, { x })} />
                </td>
                <td>
                  <NumberField label={words.cell('y', k + 1)} value={disk.y} step={grid.value} marked={marked(k, 'place')}
                    change={(y) => changeDisk(k, { y })} />
                </td>
                <td>
                  <NumberField label={words.cell('vx', k + 1)} value={disk.vx} step={speedStep} marked={marked(k, 'velocity')}
                    change={(vx) => changeDisk(k, { vx })} />
                </td>
                <td>
                  <NumberField label={words.cell('vy', k + 1)} value={disk.vy} step={speedStep} marked={marked(k, 'velocity')}
                    change={(vy) => changeDisk(k, { vy })} />
                </td>
                <td class="read">{shown(px.parts[k]!)}</td>
                <td class="read">{shown(py.parts[k]!)}</td>
              </tr>
            ))}
          </tbody>
          <tfoot>
            <tr>
              <th scope="row" colSpan={7}>
                {words.totalMomentum}
              </th>
              <td class="read">{shown(px.total)}</td>
              <td class="read">{shown(py.total)}</td>
            </tr>
          </tfoot>
        </table>
      </div>
      <div class="table-buttons">
        <button type="button" id="remove-disk" onClick={removeDisk} aria-disabled={disks.length <= 1} aria-label={words.removeDisk}>
          −
        </button>
        <output aria-label={words.numberOfDisks}>{words.disks(disks.length)}</output>
        <button type="button" id="add-disk" onClick={addDisk} aria-disabled={disks.length >= mostDisks} aria-label={words.addDisk}>
          +
        </button>
      </div>
    </section>
  );
}
